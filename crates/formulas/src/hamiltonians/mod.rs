//! Formulas with their derivatives, and formulas as Hamiltonians.

pub(crate) mod formula;
pub(crate) mod formula_hamiltonian;
