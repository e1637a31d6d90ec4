//! The names in a text.

use super::parsing::lexer::tokens;
use super::token::Token;

/// Returns the names in a text, in their order and with Greek letters spelt out: those of functions, coordinates and parameters,
/// whether or not they mean something. A text that is no sequence of symbols has none.
///
/// # Example
/// ```
/// use lie_poisson_formulas::names_in;
/// assert_eq!(names_in("2ω²·sin(u) − 0*v"), ["omega", "sin", "u", "v"]);
/// assert!(names_in("u # v").is_empty());
/// ```
#[must_use]
pub fn names_in(text: &str) -> Vec<String> {
    let name = |token| match token {
        Token::Name(name) => Some(name),
        _ => None,
    };
    let tokens = tokens(text).unwrap_or_default();
    tokens.into_iter().filter_map(|placed| name(placed.token)).collect()
}
