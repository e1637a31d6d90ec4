//! Spins on a chain of atoms in motion.

pub(super) mod chain;
mod chain_arrays;
mod lifted_chain;
