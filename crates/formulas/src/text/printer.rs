//! The printer: from a syntax tree to a text that parses to the same tree.

use super::parsing::parser::{CHOICE, SIGN, powers};
use super::syntax::{Operator, Part, Syntax};

/// How tightly a number, a name, a function or a bracket holds together.
const WHOLE: u8 = 20;

/// Returns the shortest text of a number that reads back as the same number.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-5..1e16).contains(&size) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Returns the text of a syntax tree, with no more parentheses than it needs.
///
/// A part that is used several times is defined first, unless it is a number or a name: `s1 = …; s1*exp(s1)`.
pub(crate) fn print(syntax: &Syntax) -> String {
    if let Some(text) = syntax.text() {
        return text.into();
    }
    let (uses, mut shared) = (syntax.uses(), Shared::new(syntax));
    // Each part is printed once and becomes a piece of the part that contains it.
    let mut printed: Vec<(String, u8)> = Vec::new();
    for (place, (part, _)) in syntax.parts().enumerate() {
        let is_shared = |place: usize| uses.get(place).is_some_and(|uses| *uses > 1);
        let mut text = |place: usize, least: u8| {
            let (text, binding) = printed.get_mut(place).map_or((String::new(), WHOLE), |entry| {
                match is_shared(place) {
                    true => (entry.0.clone(), entry.1),
                    false => (core::mem::take(&mut entry.0), entry.1),
                }
            });
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
            Part::Choose(comparison, parts) => {
                let [a, b, x, y] = parts.map(|part| text(part, 0));
                (format!("{CHOICE}({a} {} {b}, {x}, {y})", comparison.sign()), WHOLE)
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
        let small = matches!(part, Part::Number(_) | Part::Name(_));
        printed.push(if is_shared(place) && !small {
            (shared.define(&next.0), WHOLE)
        } else {
            next
        });
    }
    shared.definitions + &printed.pop().map_or_else(String::new, |(text, _)| text)
}

/// The definitions of parts that are used several times.
struct Shared<'a> {
    syntax: &'a Syntax,
    count: usize,
    definitions: String,
}

impl<'a> Shared<'a> {
    fn new(syntax: &'a Syntax) -> Self {
        Self { syntax, count: 0, definitions: String::new() }
    }

    /// Adds the definition of a part, and returns its name, which differs from all names in the formula.
    fn define(&mut self, text: &str) -> String {
        let name = loop {
            self.count += 1;
            let name = format!("s{}", self.count);
            if !self.syntax.names().any(|known| known == name) {
                break name;
            }
        };
        self.definitions.push_str(&format!("{name} = {text}; "));
        name
    }
}
