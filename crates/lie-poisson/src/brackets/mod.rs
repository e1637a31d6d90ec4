//! Poisson spaces, (±)-Lie–Poisson brackets, their Casimirs, and Hamiltonians on them.

pub(crate) mod poisson;
pub(crate) mod product_space;
pub(crate) mod casimirs;
pub(crate) mod hamiltonian;
