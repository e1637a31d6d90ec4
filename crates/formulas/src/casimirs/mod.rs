//! The Casimirs of an algebra from its structure constants, by exact linear algebra.

pub(crate) mod casimir_error;
pub(crate) mod residue;
pub(crate) mod surd;
pub(crate) mod bracket_table;
pub(crate) mod monomials;
pub(crate) mod null_space;
pub(crate) mod polynomial;
pub(crate) mod polynomial_casimirs;
