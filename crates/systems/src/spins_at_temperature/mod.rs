//! Classical spins in any number at a temperature.

pub(crate) mod langevin_spins;
pub(crate) mod site_rotation;
