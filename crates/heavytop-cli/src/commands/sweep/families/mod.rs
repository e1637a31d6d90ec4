//! The families that sweeps follow: tops, or motions of another Lie–Poisson system.

pub(super) mod course;
pub(super) mod family;
mod gauge;
mod measured_motion;
mod fixed_values;
pub(super) mod top_family;
mod varied_number;
pub(super) mod system_family;
pub(super) mod array_family;
pub(super) mod open;
