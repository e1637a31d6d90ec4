//! Lie algebras and Lie groups: the traits, structure constants, and direct products.

pub(crate) mod algebra;
pub(crate) mod group;
pub(crate) mod product;
pub(crate) mod jacobi;
pub(crate) mod structure_table;
pub(crate) mod structure_constants;
