//! Exact derivatives of maps between vector spaces, norms without overflow, and linear equations.

pub(crate) mod derivative;
pub(crate) mod linear_solution;
pub(crate) mod norm;
