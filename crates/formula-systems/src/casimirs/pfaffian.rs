//! The Pfaffian of an antisymmetric matrix of expressions: [`pfaffian`].

use super::expression_matrix::{ExpressionMatrix, scaled, sum};
use lie_poisson_formulas::{Expression, Expressions};
use std::collections::HashMap;

/// Returns the Pfaffian of ηX, or `None` if it is zero.
///
/// It is expanded along its first row, Pf A = Σ_j (−1)ʲ a_1j Pf A_1j with the indices j from 2 and the matrix A_1j without
/// the rows and columns 1 and j. Equal minors are computed once.
pub(crate) fn pfaffian(
    x: &ExpressionMatrix,
    form: &[f64],
    parts: &mut Expressions,
) -> Option<Expression> {
    let all = (1_u32 << x.size()) - 1;
    Minors { x, form, known: HashMap::new() }.of(all, parts)
}

struct Minors<'a> {
    x: &'a ExpressionMatrix,
    form: &'a [f64],
    /// The Pfaffians of the rows and columns in a set of bits, `None` if zero.
    known: HashMap<u32, Option<Expression>>,
}

impl Minors<'_> {
    /// Returns the Pfaffian of the rows and columns in a set, which has the bit i for the i-th.
    fn of(&mut self, set: u32, parts: &mut Expressions) -> Option<Expression> {
        if set == 0 {
            return Some(parts.number(1.0));
        }
        if let Some(known) = self.known.get(&set) {
            return *known;
        }
        let first = set.trailing_zeros() as usize;
        let others = set & (set - 1);
        let sign = self.form.get(first).copied().unwrap_or(1.0);
        let places = (0..self.x.size()).filter(|place| others >> place & 1 == 1);
        let mut terms = Vec::new();
        for (place, sign) in places.zip([sign, -sign].into_iter().cycle()) {
            let Some(entry) = self.x.entry(first, place) else { continue };
            let rest = others & !(1 << place);
            let entry = scaled(parts, sign, entry);
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
