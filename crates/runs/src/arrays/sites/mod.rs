//! Spins and vortices: systems on (so(3)∗)ᴺ.

pub(super) mod lattice_of;
pub(super) mod open_lattice;
pub(super) mod sites_arrays;
pub(super) mod sites_system;
pub(super) mod spin_start;
pub(super) mod vortex_start;
