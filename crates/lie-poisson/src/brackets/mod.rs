//! Poisson spaces, Lie–Poisson brackets with both signs, Casimirs and Hamiltonians.

pub(crate) mod poisson;
pub(crate) mod product_space;
pub(crate) mod casimirs;
pub(crate) mod hamiltonian;
pub(crate) mod sites_hamiltonian;
