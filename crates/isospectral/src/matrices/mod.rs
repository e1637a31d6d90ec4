//! Complex matrices with N known when the program runs: products, commutators, exponentials.

mod tiles;
pub(crate) mod large_matrix;
pub(crate) mod skew_hermitian;
mod real_product;
pub(crate) mod products;
mod exponential;
