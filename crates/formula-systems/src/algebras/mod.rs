//! Lie algebras with named coordinates, from the library by name, from brackets, and from tables; and states by the
//! names of their coordinates.

pub(crate) mod family;
pub(crate) mod expressions;
pub(crate) mod bracket_texts;
pub(crate) mod system_algebra;
pub(crate) mod states;
pub(crate) mod structure_table;
