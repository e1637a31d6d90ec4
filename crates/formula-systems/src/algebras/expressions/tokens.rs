//! The words and signs of the text of an algebra: [`tokens`].

use crate::error::FormulaSystemError;

/// A word, a number or a sign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Token {
    /// Letters, perhaps with digits after them, such as `so` or `R3`.
    Word(String),
    Number(usize),
    Open,
    Close,
    Comma,
    /// `+` or `⊕`
    Plus,
    /// `^`, or nothing before a raised number.
    Power,
    /// `⋉`, `|x` or `semidirect`
    Semidirect,
}

/// Returns the tokens with the columns where they begin, from 1.
///
/// # Errors
/// [`FormulaSystemError::AlgebraText`] at a character that no algebra has.
pub(super) fn tokens(text: &str) -> Result<Vec<(usize, Token)>, FormulaSystemError> {
    let letters: Vec<char> = text.chars().collect();
    let at = |place: usize| letters.get(place).copied();
    let run = |from: usize, belongs: fn(char) -> bool| {
        let run: String = letters.iter().skip(from).copied().take_while(|c| belongs(*c)).collect();
        (run.chars().count(), run)
    };
    let (mut all, mut place) = (Vec::new(), 0);
    while let Some(letter) = at(place) {
        let start = place + 1;
        let (length, token) = match letter {
            c if c.is_whitespace() => {
                place += 1;
                continue;
            }
            '(' => (1, Token::Open),
            ')' => (1, Token::Close),
            ',' => (1, Token::Comma),
            '+' | '⊕' => (1, Token::Plus),
            '^' => (1, Token::Power),
            '⋉' => (1, Token::Semidirect),
            '|' if at(place + 1) == Some('x') => (2, Token::Semidirect),
            '0'..='9' => {
                let (length, digits) = run(place, |c| c.is_ascii_digit());
                (length, Token::Number(digits.parse().unwrap_or(usize::MAX)))
            }
            c if raised(c).is_some() => {
                let (length, digits) = run(place, |c| raised(c).is_some());
                let digits: String = digits.chars().filter_map(raised).collect();
                all.push((start, Token::Power));
                (length, Token::Number(digits.parse().unwrap_or(usize::MAX)))
            }
            c if c.is_alphabetic() => {
                let (length, word) = run(place, |c| c.is_alphanumeric() && raised(c).is_none());
                let word = word.replace('ℝ', "R").replace('ℂ', "C");
                (length, if word == "semidirect" { Token::Semidirect } else { Token::Word(word) })
            }
            other => return Err(wrong(text, start, format!("`{other}` is no part of an algebra"))),
        };
        all.push((start, token));
        place += length;
        join_power_of_a_line(&mut all);
    }
    Ok(all)
}

/// Replaces R ^ 3 at the end of the tokens by R3, and the same with C.
fn join_power_of_a_line(all: &mut Vec<(usize, Token)>) {
    if let [.., (column, Token::Word(word)), (_, Token::Power), (_, Token::Number(n))] = &all[..]
        && ["R", "C"].contains(&word.as_str())
    {
        let joined = (*column, Token::Word(format!("{word}{n}")));
        all.truncate(all.len() - 3);
        all.push(joined);
    }
}

/// Returns the digit of a raised digit.
fn raised(letter: char) -> Option<char> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|c| c == letter).and_then(|n| char::from_digit(n as u32, 10))
}

/// Returns the error at a column of a text.
pub(super) fn wrong(text: &str, column: usize, problem: String) -> FormulaSystemError {
    FormulaSystemError::AlgebraText { text: text.into(), column, problem }
}
