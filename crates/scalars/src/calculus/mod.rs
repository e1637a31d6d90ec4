//! Exact derivatives of maps between vector spaces, norms without overflow and without units, and linear equations.

pub(crate) mod derivative;
pub(crate) mod norm;
pub(crate) mod block_scales;
