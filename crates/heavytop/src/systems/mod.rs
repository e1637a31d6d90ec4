//! Lie–Poisson systems that are not tops.

pub(crate) mod gyrostat;
pub(crate) mod kirchhoff;
pub(crate) mod point_vortices;
pub(crate) mod spin_chain;
pub(crate) mod spin_lattice;
