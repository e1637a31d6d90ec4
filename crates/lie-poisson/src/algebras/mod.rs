//! Lie algebras and groups: what they are, given by structure constants, and products of them.

pub(crate) mod algebra;
pub(crate) mod group;
pub(crate) mod product;
pub(crate) mod jacobi;
pub(crate) mod structure_constants;
