//! The Casimirs of an algebra from its structure constants, by exact linear algebra, or by one with tolerances.

pub(crate) mod casimir_error;
pub(crate) mod structure_entries;
pub(crate) mod bracket_table;
pub(crate) mod summands;
pub(crate) mod bounds;
pub(crate) mod monomials;
pub(crate) mod surd;
pub(crate) mod exact;
pub(crate) mod numeric;
pub(crate) mod polynomial;
pub(crate) mod polynomial_casimirs;
