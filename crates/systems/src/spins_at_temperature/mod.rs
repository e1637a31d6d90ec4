//! Classical spins in any number at a temperature, and in a field that depends on the time.

pub(crate) mod field_in_time;
pub(crate) mod langevin_spins;
pub(crate) mod site_rotation;
