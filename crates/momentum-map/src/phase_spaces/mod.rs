//! Symplectic vector spaces, cotangent bundles, and the Hopf fibration of spinors.

pub(crate) mod symplectic;
pub(crate) mod cotangent;
pub(crate) mod hopf_fibration;
