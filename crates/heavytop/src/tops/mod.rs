//! Heavy tops and rigid bodies, their invariants, and coordinates and levels on se(3)∗.

pub(crate) mod coordinate;
pub(crate) mod principal_axes;
pub(crate) mod parallel_axis;
pub(crate) mod top;
pub(crate) mod rigid_body;
pub(crate) mod invariants;
pub(crate) mod energy_level;
