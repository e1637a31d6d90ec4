//! Charts in the terminal, of dots in braille characters.

mod dots;
pub(super) mod terminal_charts;
