//! Lie algebras from the entries of a table, of a dimension that is known only when the program runs.

pub(crate) mod structure_entries;
pub(crate) mod any_dimension;
