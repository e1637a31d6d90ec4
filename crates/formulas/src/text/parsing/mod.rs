//! From a text to its syntax tree: tokens, operators and their operands, and sums over an index.

pub(crate) mod lexer;
pub(crate) mod parser;
mod sums;
