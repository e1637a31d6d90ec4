//! Sums over an index, such as `sum(S[i]·S[i+1])`, which are written out term by term.

use super::parser::{Bound, Parsed, Parser};
use crate::names::vocabulary::Vocabulary;
use crate::text::formula_error::{FormulaError, Problem};
use crate::text::syntax::{Operator, Part};
use crate::text::token::{Comparison, Placed, Token};
use core::ops::{Range, RangeInclusive};

/// The largest number of terms of a sum.
const MOST_TERMS: usize = 1 << 16;

/// The largest number of parts of a formula with sums, which within each other multiply their terms.
const MOST_PARTS: usize = 1 << 18;

/// The indices of a sum, and which of their values belong together.
struct Indices {
    names: Vec<String>,
    /// Whether each index is below the next one.
    increasing: bool,
}

impl Parser<'_> {
    /// Parses what follows `sum(`.
    pub(super) fn sum(&mut self, span: Range<usize>, opened: Range<usize>) -> Parsed<usize> {
        self.level += 1;
        self.check_level()?;
        let body = self.place;
        let end = self.end_of_argument();
        let indices = self.indices(body..end, &span)?;
        let after = self.place;
        let mut sum = None;
        let ranges = indices.names.iter().map(|name| self.values(name, body..end, &span));
        let ranges = ranges.collect::<Parsed<Vec<_>>>()?;
        let count = ranges.iter().map(|range| range.clone().count());
        let needed = count.fold(1, usize::saturating_mul);
        if needed > MOST_TERMS {
            let problem = Problem::TooLarge { needed, limit: MOST_TERMS };
            return Err(FormulaError::new(span, problem));
        }
        for values in combinations(&ranges, indices.increasing) {
            let names = indices.names.iter().cloned().zip(values);
            let bound = names.map(|(name, value)| Bound { name, value });
            let before = self.bound.len();
            self.bound.extend(bound);
            self.place = body;
            let term = self.expression(0)?;
            if term > MOST_PARTS {
                let problem = Problem::TooLarge { needed: term, limit: MOST_PARTS };
                return Err(FormulaError::new(span, problem));
            }
            self.bound.truncate(before);
            if self.place != end {
                self.close(&Token::Comma, opened.clone(), "(", ")")?;
            }
            let add = |sum| self.syntax.add(Part::Binary(Operator::Add, sum, term), span.clone());
            sum = Some(sum.map_or(term, add));
        }
        self.place = after;
        self.close(&Token::Close, opened, "(", ")")?;
        self.level -= 1;
        let index = indices.names.join(", ");
        sum.ok_or_else(|| FormulaError::new(span, Problem::EmptySum { index }))
    }

    /// Parses an index in brackets: a number, or an index of a sum, perhaps with a number added or subtracted.
    pub(super) fn index(&mut self) -> Parsed<usize> {
        let Placed { token, span } = self.take();
        let wrong = |problem| Err(FormulaError::new(span.clone(), problem));
        let first = match token {
            Token::Number(value) => whole(value),
            Token::Name(name) => match self.bound.iter().rev().find(|bound| bound.name == name) {
                Some(bound) => Some(bound.value),
                None => return wrong(Problem::NotAnIndex),
            },
            _ => return wrong(Problem::NotAnIndex),
        };
        let (shift, sign) = match self.peek().token {
            Token::Plus => (true, 1),
            Token::Minus => (true, -1),
            _ => (false, 0),
        };
        let mut index = first.and_then(|first| i64::try_from(first).ok());
        if shift {
            self.place += 1;
            let Placed { token: Token::Number(value), .. } = self.take() else {
                return wrong(Problem::NotAnIndex);
            };
            let shift = whole(value).and_then(|value| i64::try_from(value).ok());
            index = index.zip(shift).map(|(index, shift)| index + sign * shift);
        }
        let index = index.filter(|index| *index > 0).and_then(|index| usize::try_from(index).ok());
        index.map_or_else(|| wrong(Problem::NotAnIndex), Ok)
    }

    /// Returns the place of the comma or parenthesis that ends the argument that begins at the next token.
    fn end_of_argument(&self) -> usize {
        let mut depth = 0_usize;
        for (place, placed) in self.tokens.iter().enumerate().skip(self.place) {
            match placed.token {
                Token::Open | Token::OpenIndex => depth += 1,
                Token::Comma if depth == 0 => return place,
                Token::Close if depth == 0 => return place,
                Token::Close | Token::CloseIndex => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
        self.tokens.len().saturating_sub(1)
    }

    /// Returns the indices that are listed after the formula, or the only one in it, and goes on to the closing parenthesis.
    fn indices(&mut self, body: Range<usize>, span: &Range<usize>) -> Parsed<Indices> {
        let wrong = || FormulaError::new(span.clone(), Problem::SumIndex);
        let found = self.free_indices(body.clone());
        self.place = body.end;
        if !self.take_if(&Token::Comma) {
            return match found.as_slice() {
                [_] => Ok(Indices { names: found, increasing: false }),
                _ => Err(wrong()),
            };
        }
        let mut indices = Indices { names: Vec::new(), increasing: false };
        loop {
            match self.take().token {
                Token::Name(name) if found.contains(&name) && !indices.names.contains(&name) => {
                    indices.names.push(name);
                }
                _ => return Err(wrong()),
            }
            let is_first = indices.names.len() == 1;
            if self.take_if(&Token::Comparison(Comparison::Less)) {
                if !is_first && !indices.increasing {
                    return Err(wrong());
                }
                indices.increasing = true;
            } else if indices.increasing || !self.take_if(&Token::Comma) {
                break;
            }
        }
        Ok(indices)
    }

    /// Returns the names in brackets that are the index of no sum around this one.
    fn free_indices(&self, body: Range<usize>) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for (_, name, _) in self.uses(body) {
            if !names.contains(&name) && !self.bound.iter().any(|bound| bound.name == name) {
                names.push(name);
            }
        }
        names
    }

    /// Returns where the tokens have a name, an opening bracket and an index, which may be shifted: the first name, that of
    /// the index, and the shift.
    fn uses(&self, body: Range<usize>) -> Vec<(Option<String>, String, i64)> {
        let token = |place: usize| self.tokens.get(place).map(|placed| &placed.token);
        let mut uses = Vec::new();
        for place in body.clone().filter(|place| token(*place) == Some(&Token::OpenIndex)) {
            let Some(Token::Name(index)) = token(place + 1) else { continue };
            let shift = match (token(place + 2), token(place + 3)) {
                (Some(Token::Plus), Some(&Token::Number(shift))) => shift as i64,
                (Some(Token::Minus), Some(&Token::Number(shift))) => -(shift as i64),
                _ => 0,
            };
            let of = match place.checked_sub(1).and_then(token) {
                Some(Token::Name(name)) if place > body.start => Some(name.clone()),
                _ => None,
            };
            uses.push((of, index.clone(), shift));
        }
        uses
    }

    /// Returns the values of an index for which all that it numbers exists.
    fn values(
        &self,
        index: &str,
        body: Range<usize>,
        span: &Range<usize>,
    ) -> Parsed<RangeInclusive<usize>> {
        let (mut first, mut last) = (1_i64, i64::MAX);
        for (of, _, shift) in self.uses(body).into_iter().filter(|(_, name, _)| name == index) {
            let Some(count) = of.and_then(|name| count(self.names, &name)) else { continue };
            first = first.max(1_i64.saturating_sub(shift));
            last = last.min(i64::try_from(count).unwrap_or(i64::MAX).saturating_sub(shift));
        }
        match (usize::try_from(first), usize::try_from(last.max(0))) {
            (Ok(first), Ok(last)) if last < usize::MAX >> 1 => Ok(first..=last),
            _ => Err(FormulaError::new(span.clone(), Problem::SumIndex)),
        }
    }
}

/// Returns the number of components of a vector, or of the names `S_1`, `S_2`, … of a name `S` that has no meaning itself.
fn count(names: &Vocabulary, name: &str) -> Option<usize> {
    if let Some(dimension) = names.dimension(name) {
        return Some(dimension);
    }
    let count = (1..).take_while(|i| names.meaning(&format!("{name}_{i}")).is_some()).count();
    (count > 0).then_some(count)
}

/// Returns a whole number from 0 on, as a number.
fn whole(value: f64) -> Option<usize> {
    ((0.0..=1e9).contains(&value) && value.fract() == 0.0).then_some(value as usize)
}

/// Returns all values of several indices, in order, perhaps only those in which each is below the next one.
fn combinations(ranges: &[RangeInclusive<usize>], increasing: bool) -> Vec<Vec<usize>> {
    ranges.iter().fold(vec![Vec::new()], |all, range| {
        let extend = |values: Vec<usize>| {
            let least = values.last().map_or(0, |last| if increasing { last + 1 } else { 0 });
            let next = range.clone().filter(move |value| *value >= least);
            next.map(move |value| values.iter().copied().chain([value]).collect())
        };
        all.into_iter().flat_map(extend).collect()
    })
}
