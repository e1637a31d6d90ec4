//! Poisson maps and momentum maps, their fibres and lifts, and collective Hamiltonians.

pub(crate) mod recentring;
pub(crate) mod poisson_map;
pub(crate) mod fibre;
pub(crate) mod products;
pub(crate) mod momentum_map;
pub(crate) mod symplectic_representation;
pub(crate) mod quadratic_momentum_map;
pub(crate) mod collective_hamiltonian;
pub(crate) mod noether;
