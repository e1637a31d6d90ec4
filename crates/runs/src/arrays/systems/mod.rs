//! The systems of arrays, each in one file.

pub(super) mod many_vortices;
pub(super) mod sphere_fluid;
pub(super) mod spin_lattice;
pub(super) mod vibrating_lattice;
