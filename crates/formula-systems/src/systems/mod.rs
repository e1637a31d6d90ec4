//! Lie–Poisson systems by formula: an algebra, a Hamiltonian, and the Casimirs.

pub(crate) mod formula_system;
