//! Lie algebras with named coordinates: of the library by name, of brackets, and of tables; states by the names of
//! their coordinates.

pub(crate) mod bracket_texts;
pub(crate) mod system_algebra;
pub(crate) mod states;
pub(crate) mod structure_table;
