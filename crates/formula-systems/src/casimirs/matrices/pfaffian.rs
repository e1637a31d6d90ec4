//! Pfaffians of an antisymmetric matrix of expressions: [`Pfaffians`].

use super::expression_matrix::{ExpressionMatrix, scaled, sum};
use lie_poisson_formulas::{Expression, Expressions};
use std::collections::HashMap;

/// An antisymmetric matrix A with the Pfaffians of those sets of rows and columns that were needed.
///
/// One is expanded along its first row, Pf A = Σ_j (−1)ʲ a_1j Pf A_1j with the indices j from 2 and the matrix A_1j without
/// the rows and columns 1 and j. Equal minors are computed once.
pub(crate) struct Pfaffians {
    /// The entries above the diagonal of each row, as multiples of expressions, `None` if zero.
    rows: Vec<Vec<Option<(f64, Expression)>>>,
    /// The Pfaffians of the rows and columns in a set of bits, `None` if zero.
    known: HashMap<u32, Option<Expression>>,
}

impl Pfaffians {
    /// Creates the matrix of up to 32 rows with these entries above the diagonal.
    pub(crate) fn new(
        size: usize,
        entry: impl Fn(usize, usize) -> Option<(f64, Expression)>,
    ) -> Self {
        let row = |i: usize| (i + 1..size).map(|j| entry(i, j)).collect();
        Self { rows: (0..size).map(row).collect(), known: HashMap::new() }
    }

    /// Creates ηX for a matrix X that respects the form η.
    pub(crate) fn with_form(x: &ExpressionMatrix, form: &[f64]) -> Self {
        let sign = |row: usize| form.get(row).copied().unwrap_or(1.0);
        Self::new(x.size(), |row, column| x.entry(row, column).map(|entry| (sign(row), entry)))
    }

    /// Returns the Pfaffian of the whole matrix, or `None` if it is zero.
    pub(crate) fn of_all(&mut self, parts: &mut Expressions) -> Option<Expression> {
        let all = (0..self.rows.len()).fold(0, |set, row| set | 1 << row);
        self.of(all, parts)
    }

    /// Returns the Pfaffian of the rows and columns in a set, which has the bit i for the i-th, or `None` if it is zero.
    pub(crate) fn of(&mut self, set: u32, parts: &mut Expressions) -> Option<Expression> {
        if set == 0 {
            return Some(parts.number(1.0));
        }
        if let Some(known) = self.known.get(&set) {
            return *known;
        }
        let first = set.trailing_zeros() as usize;
        let others = set & (set - 1);
        let row = self.rows.get(first)?.clone();
        let places = (first + 1..).zip(row).filter(|(place, _)| others >> place & 1 == 1);
        let mut terms = Vec::new();
        for ((place, entry), sign) in places.zip([1.0, -1.0].into_iter().cycle()) {
            let Some((weight, entry)) = entry else { continue };
            let rest = others & !(1 << place);
            let entry = scaled(parts, sign * weight, entry);
            if rest == 0 {
                terms.push(entry);
            } else if let Some(minor) = self.of(rest, parts) {
                terms.push(parts.multiply(entry, minor));
            }
        }
        let minor = sum(parts, terms);
        self.known.insert(set, minor);
        minor
    }
}
