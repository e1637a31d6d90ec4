//! Exact derivatives of maps between vector spaces, and norms without overflow.

pub(crate) mod derivative;
pub(crate) mod norm;
