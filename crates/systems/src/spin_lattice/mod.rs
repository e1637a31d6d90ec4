//! Classical spins on lattices: at rest, and on atoms in motion.

pub(crate) mod heisenberg_lattice;
pub(crate) mod vibrating_lattice;
