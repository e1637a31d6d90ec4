//! The tokens of a text, with their places.

use crate::names::letters::{begins_name, canonical, continues_name};
use crate::text::formula_error::{FormulaError, MOST_BYTES, Problem};
use crate::text::token::{Comparison, Placed, Token};

/// Returns the tokens of a text, the last of which is [`Token::End`].
pub(crate) fn tokens(text: &str) -> Result<Vec<Placed>, FormulaError> {
    if text.len() > MOST_BYTES {
        let problem = Problem::TooLong { length: text.len(), limit: MOST_BYTES };
        return Err(FormulaError::new(0..0, problem));
    }
    let (mut found, mut rest) = (Vec::new(), text.trim_start());
    while let Some(first) = rest.chars().next() {
        let start = text.len() - rest.len();
        let (token, length) = next(first, rest)
            .map_err(|(problem, length)| FormulaError::new(start..start + length, problem))?;
        found.push(Placed { token, span: start..start + length });
        rest = rest.get(length..).unwrap_or_default().trim_start();
    }
    let end = text.trim_end().len();
    found.push(Placed { token: Token::End, span: end..end });
    Ok(found)
}

/// Returns the token at the beginning of a text and its length, or the problem and the length of the text that causes
/// it.
fn next(first: char, text: &str) -> Result<(Token, usize), (Problem, usize)> {
    let second = text.get(first.len_utf8()..).unwrap_or_default().chars().next();
    let fraction = |above: f64, below: f64| Token::Number(above / below);
    let token = match first {
        '0'..='9' => return number(text),
        '.' if second.is_some_and(|digit| digit.is_ascii_digit()) => return number(text),
        '+' => Token::Plus,
        '-' | '−' | '–' => Token::Minus,
        '*' if second == Some('*') => return Ok((Token::Power, 2)),
        '*' | '∗' => Token::Times,
        '/' | '÷' | '∕' => Token::Over,
        '^' => Token::Power,
        '·' | '⋅' | '∙' => Token::Dot,
        '×' | '⨯' => Token::Cross,
        '√' => Token::Root,
        '(' => Token::Open,
        ')' => Token::Close,
        '[' => Token::OpenIndex,
        ']' => Token::CloseIndex,
        '|' | '‖' | '∥' => Token::Bar,
        ',' => Token::Comma,
        '<' if second == Some('=') => return Ok((Token::Comparison(Comparison::AtMost), 2)),
        '>' if second == Some('=') => return Ok((Token::Comparison(Comparison::AtLeast), 2)),
        '<' => Token::Comparison(Comparison::Less),
        '>' => Token::Comparison(Comparison::Greater),
        '≤' | '⩽' => Token::Comparison(Comparison::AtMost),
        '≥' | '⩾' => Token::Comparison(Comparison::AtLeast),
        '½' => fraction(1.0, 2.0),
        '⅓' => fraction(1.0, 3.0),
        '⅔' => fraction(2.0, 3.0),
        '¼' => fraction(1.0, 4.0),
        '¾' => fraction(3.0, 4.0),
        '⅙' => fraction(1.0, 6.0),
        '⅛' => fraction(1.0, 8.0),
        _ if raised(first).is_some() => return superscript(text),
        _ if begins_name(first) => {
            let length = text.find(|letter| !continues_name(letter)).unwrap_or(text.len());
            return Ok((Token::Name(canonical(text.get(..length).unwrap_or_default())), length));
        }
        _ => return Err((unknown(first), first.len_utf8())),
    };
    Ok((token, first.len_utf8()))
}

fn unknown(character: char) -> Problem {
    let suggestion = match character {
        '.' | '•' => Some("·"),
        '{' | '⟨' => Some("("),
        '}' | '⟩' => Some(")"),
        '⊗' | '∧' => Some("×"),
        '′' | '\'' => Some("_"),
        ';' => Some(","),
        _ => None,
    };
    Problem::UnknownCharacter { character, suggestion }
}

/// Returns the number of leading digits.
fn digits(text: &str) -> usize {
    text.find(|digit: char| !digit.is_ascii_digit()).unwrap_or(text.len())
}

/// Reads a number such as `2`, `0.5`, `.5`, `1.` or `6.02e23`.
fn number(text: &str) -> Result<(Token, usize), (Problem, usize)> {
    let after = |length: usize| text.get(length..).unwrap_or_default();
    let mut length = digits(text);
    if after(length).starts_with('.') {
        length += 1 + digits(after(length + 1));
    }
    if after(length).starts_with(['e', 'E']) {
        let signed = usize::from(after(length + 1).starts_with(['+', '-']));
        let exponent = digits(after(length + 1 + signed));
        if exponent > 0 {
            length += 1 + signed + exponent;
        }
    }
    if after(length).starts_with('.') {
        let whole = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        let text = text.get(..whole.max(length)).unwrap_or_default();
        return Err((Problem::NotANumber { text: text.to_owned() }, text.len()));
    }
    let digits = text.get(..length).unwrap_or_default();
    let Ok(value) = digits.parse::<f64>() else {
        return Err((Problem::NotANumber { text: digits.to_owned() }, length));
    };
    let mantissa = digits.split(['e', 'E']).next().unwrap_or_default();
    let is_zero = !mantissa.contains(|digit: char| matches!(digit, '1'..='9'));
    if value.is_normal() || is_zero {
        Ok((Token::Number(value), length))
    } else {
        Err((Problem::OutOfRange { text: digits.to_owned() }, length))
    }
}

/// Returns the digit that a raised digit stands for, or −1 for a raised minus sign.
fn raised(letter: char) -> Option<i8> {
    Some(match letter {
        '⁻' => -1,
        '⁰' => 0,
        '¹' => 1,
        '²' => 2,
        '³' => 3,
        '⁴' => 4,
        '⁵' => 5,
        '⁶' => 6,
        '⁷' => 7,
        '⁸' => 8,
        '⁹' => 9,
        _ => return None,
    })
}

/// Reads a raised whole number such as ², ¹² or ⁻³.
fn superscript(text: &str) -> Result<(Token, usize), (Problem, usize)> {
    let length = text.find(|letter| raised(letter).is_none()).unwrap_or(text.len());
    let whole = text.get(..length).unwrap_or_default();
    let (sign, magnitude) = whole.strip_prefix('⁻').map_or((1.0, whole), |rest| (-1.0, rest));
    let wrong = || (Problem::NotANumber { text: whole.to_owned() }, length);
    if magnitude.is_empty() || magnitude.chars().count() > 9 {
        return Err(wrong());
    }
    let mut value = 0.0;
    for digit in magnitude.chars().filter_map(raised) {
        if digit < 0 {
            return Err(wrong());
        }
        value = 10.0 * value + f64::from(digit);
    }
    Ok((Token::Superscript(sign * value), length))
}
