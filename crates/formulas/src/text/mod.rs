//! The language of formulas: errors with a position, tokens, the syntax tree, the parser and the printer.

pub(crate) mod formula_error;
pub(crate) mod suggestion;
pub(crate) mod token;
pub(crate) mod syntax;
pub(crate) mod expressions;
pub(crate) mod parsing;
pub(crate) mod printer;
pub(crate) mod names_in_text;
