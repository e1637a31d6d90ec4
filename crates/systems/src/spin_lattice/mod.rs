//! Classical spins that sit on atoms in motion.

pub(crate) mod vibrating_lattice;
