//! Formulas with their derivatives, and formulas as Hamiltonians.

pub(crate) mod value_error;
pub(crate) mod formula;
pub(crate) mod failing_part;
pub(crate) mod checked;
pub(crate) mod formula_hamiltonian;
