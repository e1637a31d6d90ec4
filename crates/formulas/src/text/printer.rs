//! The printer: from a syntax tree to a text that parses to the same tree.

use super::parser::{SIGN, powers};
use super::syntax::{Operator, Part, Syntax};

/// How tightly a number, a name, a function or a bracket holds together.
const WHOLE: u8 = 20;

/// Returns a number as text: the shortest that reads back as the same number.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-5..1e16).contains(&size) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Returns the text of a syntax tree, with no more parentheses than it needs.
pub(crate) fn print(syntax: &Syntax) -> String {
    // Each part is printed once and becomes a piece of the part that contains it.
    let mut printed: Vec<(String, u8)> = Vec::new();
    for (part, _) in syntax.parts() {
        let mut text = |place: usize, least: u8| {
            let (text, binding) = printed
                .get_mut(place)
                .map_or((String::new(), WHOLE), |entry| (core::mem::take(&mut entry.0), entry.1));
            if binding < least { format!("({text})") } else { text }
        };
        let next = match part {
            Part::Number(value) => (number(value), WHOLE),
            Part::Name(place) => (syntax.name(place).to_owned(), WHOLE),
            Part::Negate(x) => (format!("-{}", text(x, SIGN)), SIGN),
            Part::Norm(x) => (format!("|{}|", text(x, 0)), WHOLE),
            Part::Component(x, index) => (format!("{}[{index}]", text(x, WHOLE)), WHOLE),
            Part::Call(function, [x, y]) => {
                let mut call = format!("{}({}", function.name(), text(x, 0));
                if function.arguments() == 2 {
                    call.push_str(", ");
                    call.push_str(&text(y, 0));
                }
                call.push(')');
                (call, WHOLE)
            }
            Part::Binary(operator, x, y) => {
                let sign = match operator {
                    Operator::Add => " + ",
                    Operator::Subtract => " - ",
                    Operator::Multiply => "*",
                    Operator::Divide => "/",
                    Operator::Dot => "·",
                    Operator::Cross => "×",
                    Operator::Power => "^",
                };
                let (left, right) = powers(operator);
                let mut both =
                    if operator == Operator::Power { text(x, WHOLE) } else { text(x, left) };
                both.push_str(sign);
                // A sign may stand on the right of every operator, even of a power: 2^-3.
                both.push_str(&text(y, if operator == Operator::Power { SIGN } else { right }));
                (both, left)
            }
        };
        printed.push(next);
    }
    printed.pop().map_or_else(String::new, |(text, _)| text)
}
