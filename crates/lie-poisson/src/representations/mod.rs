//! Linear representations of groups, and their semidirect products.

pub(crate) mod representation;
pub(crate) mod semidirect;
pub(crate) mod real_matrices;
pub(crate) mod unitary_matrices;
pub(crate) mod cocycle;
pub(crate) mod derived;
pub(crate) mod odd_powers;
pub(crate) mod sp1;
pub(crate) mod euclidean;
