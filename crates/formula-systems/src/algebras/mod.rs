//! Lie algebras with named coordinates: of the library by name, and of brackets; states by the names of coordinates.

pub(crate) mod bracket_texts;
pub(crate) mod system_algebra;
pub(crate) mod states;
