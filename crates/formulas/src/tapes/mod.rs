//! Expressions as lists of instructions on registers, over any scalar.

pub(crate) mod instruction;
pub(crate) mod selection;
pub(crate) mod allocation;
pub(crate) mod linear;
pub(crate) mod tape;
