//! The text of an algebra: [`parse`].

use super::atoms::{Argument, FORMS, atom};
use super::part::{Part, Space};
use super::tokens::{Token, tokens, wrong};
use crate::algebras::family::MOST_DIMENSIONS;
use crate::error::FormulaSystemError;
use nalgebra::DMatrix;
use std::collections::BTreeMap;

/// Returns the algebra of a text:
///
/// ```text
/// sum        =  product { "+" product }
/// product    =  power { "⋉" vectors }
/// power      =  ( name [ "(" arguments ")" ] | "(" sum ")" ) [ "^" number ]
/// vectors    =  space | "(" space { "+" space } ")"        each with [ "^" number ]
/// ```
///
/// A space is one such as R3 or C2, or the name of a representation that is given by its matrices.
///
/// # Errors
/// [`FormulaSystemError::AlgebraText`] with the column where the text is no algebra, and
/// [`FormulaSystemError::NoAlgebra`] for a name that there is not.
pub(in crate::algebras) fn parse(
    text: &str,
    given: &BTreeMap<String, Vec<DMatrix<f64>>>,
) -> Result<Part, FormulaSystemError> {
    let tokens = tokens(text)?;
    for name in given.keys() {
        let wrong = |problem: &str| FormulaSystemError::Representation {
            name: name.clone(),
            problem: problem.into(),
        };
        if space(name).is_some() {
            return Err(wrong("this is the name of a space that there is"));
        }
        if !tokens.iter().any(|(_, token)| word(token) == Some(name)) {
            return Err(wrong("the expression of the algebra does not name it"));
        }
    }
    let mut parser = Parser { text, tokens, next: 0, level: 0, given };
    let part = parser.sum()?;
    match parser.peek() {
        None => Ok(part),
        Some(_) => Err(parser.expected("the end, `+`, `^` or `⋉`")),
    }
}

struct Parser<'a> {
    text: &'a str,
    tokens: Vec<(usize, Token)>,
    next: usize,
    /// The number of parentheses around the next token.
    level: usize,
    /// The matrices of representations by name.
    given: &'a BTreeMap<String, Vec<DMatrix<f64>>>,
}

/// The name and the matrices of a representation, and the number of copies.
type GivenVectors<'a> = (&'a str, &'a [DMatrix<f64>], usize);

/// The largest number of parentheses inside each other.
const MOST_LEVELS: usize = 64;

impl<'a> Parser<'a> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.next).map(|(_, token)| token)
    }

    /// Takes the next token if it is this one.
    fn take(&mut self, token: &Token) -> bool {
        let is_next = self.peek() == Some(token);
        self.next += usize::from(is_next);
        is_next
    }

    fn column(&self) -> usize {
        let end = self.text.chars().count() + 1;
        self.tokens.get(self.next).map_or(end, |(column, _)| *column)
    }

    /// Returns the error that something else was expected at the next token.
    fn expected(&self, what: &str) -> FormulaSystemError {
        let found = if self.peek().is_some() { "here" } else { "where the text ends" };
        wrong(self.text, self.column(), format!("{what} must stand {found}"))
    }

    fn sum(&mut self) -> Result<Part, FormulaSystemError> {
        let mut part = self.product()?;
        while self.take(&Token::Plus) {
            part = part.plus(&self.product()?)?;
        }
        Ok(part)
    }

    fn product(&mut self) -> Result<Part, FormulaSystemError> {
        let mut part = self.power()?;
        while self.take(&Token::Semidirect) {
            if let Some(given) = self.given_vectors()? {
                let vectors = |(_, matrices, copies): &(_, &[DMatrix<f64>], usize)| {
                    copies.saturating_mul(matrices.first().map_or(0, DMatrix::nrows))
                };
                let vectors = given.iter().map(vectors).fold(0, usize::saturating_add);
                require_dimension(part.coordinates.dimension().saturating_add(vectors))?;
                part = part.acting_by(&given)?;
                continue;
            }
            let column = self.column();
            let (space, copies) = self.vectors()?;
            let vectors = copies.saturating_mul(space.dimension());
            require_dimension(part.coordinates.dimension().saturating_add(vectors))?;
            let own = part.acts.as_ref().map(|acts| acts.space);
            let made = part.acting(copies).filter(|_| own == Some(space));
            part = made.ok_or_else(|| {
                let acts = match own {
                    Some(own) => format!("the algebra before it acts on {}", own.name()),
                    None => "the algebra before it acts on no space of its own".into(),
                };
                wrong(self.text, column, format!("{acts}, and not on {}", space.name()))
            })??;
        }
        Ok(part)
    }

    fn power(&mut self) -> Result<Part, FormulaSystemError> {
        let column = self.column();
        let part = match self.peek().cloned() {
            Some(Token::Open) => {
                self.open()?;
                let part = self.sum()?;
                self.close()?;
                self.level -= 1;
                part
            }
            Some(Token::Word(word)) => {
                self.next += 1;
                self.named(&word, column)?
            }
            _ => return Err(self.expected("an algebra, such as so(3),")),
        };
        match self.exponent()? {
            1 => Ok(part),
            count => {
                let dimension = part.coordinates.dimension().saturating_mul(count);
                require_dimension(dimension)?;
                part.power(count)
            }
        }
    }

    /// Returns the algebra of a word and of the arguments after it.
    fn named(&mut self, word: &str, column: usize) -> Result<Part, FormulaSystemError> {
        let begin = self.next - 1;
        let (name, mut arguments) = match space(word) {
            Some(Space::Real(n)) => ("R", vec![Argument::Number(n)]),
            _ => (word, Vec::new()),
        };
        if self.take(&Token::Open) {
            loop {
                arguments.push(match self.peek() {
                    Some(&Token::Number(n)) => Argument::Number(n),
                    Some(Token::Word(word)) if word == "R" => Argument::Reals,
                    _ => return Err(self.expected("a number")),
                });
                self.next += 1;
                if !self.take(&Token::Comma) {
                    break;
                }
            }
            self.close()?;
        }
        atom(name, &arguments).unwrap_or_else(|| {
            let written = self.tokens.get(begin + 1).map(|_| self.column());
            let end = written.unwrap_or(self.text.chars().count() + 1);
            let letters = self.text.chars().skip(column - 1).take(end - column);
            let name = letters.collect::<String>().trim().to_owned();
            Err(FormulaSystemError::NoAlgebra { name, names: FORMS.to_vec() })
        })
    }

    /// Returns the representations of one's own after `⋉`, each with the number of its copies; `None` if the space there is
    /// another one.
    fn given_vectors(&mut self) -> Result<Option<Vec<GivenVectors<'a>>>, FormulaSystemError> {
        let (start, given) = (self.next, self.given);
        let is_many = self.take(&Token::Open);
        let mut all = Vec::new();
        loop {
            let found = self.peek().and_then(word).and_then(|name| given.get_key_value(name));
            let Some((name, matrices)) = found else {
                if all.is_empty() {
                    self.next = start;
                    return Ok(None);
                }
                return Err(self.expected("a representation that is given"));
            };
            self.next += 1;
            all.push((name.as_str(), matrices.as_slice(), self.exponent()?));
            if !is_many || !self.take(&Token::Plus) {
                break;
            }
        }
        if is_many {
            self.close()?;
        }
        Ok(Some(all))
    }

    /// Returns the space after `⋉`, and how many copies of it there are.
    fn vectors(&mut self) -> Result<(Space, usize), FormulaSystemError> {
        let needed = match self.given.is_empty() {
            true => "a space of vectors, such as R3 or C2,",
            false => "a space of vectors, such as R3 or C2, or a representation that is given,",
        };
        if self.peek() != Some(&Token::Open) {
            let Some(space) = self.peek().and_then(word).and_then(space) else {
                return Err(self.expected(needed));
            };
            self.next += 1;
            return Ok((space, self.exponent()?));
        }
        self.open()?;
        let (first, mut copies) = self.vectors()?;
        while self.take(&Token::Plus) {
            let column = self.column();
            let (other, count) = self.vectors()?;
            if other != first {
                let problem = format!("{} stands beside {}", other.name(), first.name());
                return Err(wrong(self.text, column, problem));
            }
            copies = copies.saturating_add(count);
        }
        self.close()?;
        self.level -= 1;
        Ok((first, copies.saturating_mul(self.exponent()?)))
    }

    /// Returns the number after `^`, or 1 without one.
    fn exponent(&mut self) -> Result<usize, FormulaSystemError> {
        if !self.take(&Token::Power) {
            return Ok(1);
        }
        match self.peek() {
            Some(&Token::Number(count)) if count > 0 => {
                self.next += 1;
                Ok(count)
            }
            _ => Err(self.expected("a number from 1 on")),
        }
    }

    /// Takes an opening parenthesis.
    fn open(&mut self) -> Result<(), FormulaSystemError> {
        self.next += 1;
        self.level += 1;
        match self.level <= MOST_LEVELS {
            true => Ok(()),
            false => {
                Err(self
                    .expected(&format!("no more than {MOST_LEVELS} parentheses inside each other")))
            }
        }
    }

    fn close(&mut self) -> Result<(), FormulaSystemError> {
        match self.take(&Token::Close) {
            true => Ok(()),
            false => Err(self.expected("`)`")),
        }
    }
}

fn word(token: &Token) -> Option<&str> {
    match token {
        Token::Word(word) => Some(word),
        _ => None,
    }
}

/// Returns the space of a word such as R3 or C2.
fn space(word: &str) -> Option<Space> {
    let number = |digits: &str| digits.parse().ok().filter(|n: &usize| *n > 0);
    match (word.strip_prefix('R'), word.strip_prefix('C')) {
        (Some(digits), _) => number(digits).map(Space::Real),
        (_, Some(digits)) => number(digits).map(Space::Complex),
        _ => None,
    }
}

fn require_dimension(count: usize) -> Result<(), FormulaSystemError> {
    let most = MOST_DIMENSIONS;
    match count <= most {
        true => Ok(()),
        false => Err(FormulaSystemError::Dimension { count, most }),
    }
}
