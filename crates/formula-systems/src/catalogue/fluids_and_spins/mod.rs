//! Vortices and spins by name.

pub(super) mod elliptical_vortex;
pub(super) mod spin_chain;
pub(super) mod vortices;
