//! Powers of matrices of expressions, in which zeros cost nothing: [`ExpressionMatrix`].

use super::matrix_algebra::Structure;
use super::symmetry::{Place, images};
use lie_poisson_formulas::{Expression, Expressions};
use nalgebra::DMatrix;

/// A power of a matrix of an algebra, whose entries are expressions, or zero.
#[derive(Clone, Debug)]
pub(crate) struct ExpressionMatrix {
    size: usize,
    structure: Structure,
    /// Whether the exponent is odd.
    is_odd: bool,
    entries: Vec<Option<Expression>>,
}

impl ExpressionMatrix {
    /// Creates the matrix Σ_a μ_a M_a of expressions μ_a and matrices of numbers with a structure.
    pub(crate) fn linear(
        parts: &mut Expressions,
        coordinates: &[Expression],
        matrices: &[DMatrix<f64>],
        structure: &Structure,
    ) -> Self {
        let size = matrices.first().map_or(0, DMatrix::nrows);
        Self::of(parts, size, (structure, true), |parts, (row, column)| {
            let weights = matrices.iter().map(|matrix| matrix[(row, column)]);
            let terms = coordinates.iter().copied().zip(weights);
            let terms: Vec<Expression> = terms
                .filter(|(_, weight)| *weight != 0.0)
                .map(|(x, weight)| scaled(parts, weight, x))
                .collect();
            sum(parts, terms)
        })
    }

    /// Creates a matrix. Of the entries that determine each other one is computed.
    fn of(
        parts: &mut Expressions,
        size: usize,
        (structure, is_odd): (&Structure, bool),
        entry: impl Fn(&mut Expressions, Place) -> Option<Expression>,
    ) -> Self {
        let mut entries = vec![None; size * size];
        for place in places(size) {
            let images = images(structure, size, is_odd, place);
            let is_first = images.iter().all(|(image, _)| place <= *image);
            let is_zero = images.iter().any(|(image, sign)| *image == place && *sign < 0.0);
            if !is_first || is_zero {
                continue;
            }
            let Some(value) = entry(parts, place) else { continue };
            let negative = images.iter().any(|(_, sign)| *sign < 0.0).then(|| parts.negate(value));
            for ((row, column), sign) in images {
                if let Some(entry) = entries.get_mut(row * size + column) {
                    *entry = if sign < 0.0 { negative } else { Some(value) };
                }
            }
        }
        Self { size, structure: structure.clone(), is_odd, entries }
    }

    /// Returns the number of rows.
    pub(crate) const fn size(&self) -> usize {
        self.size
    }

    /// Returns an entry, or `None` for zero.
    pub(crate) fn entry(&self, row: usize, column: usize) -> Option<Expression> {
        self.entries.get(row * self.size + column).copied().flatten()
    }

    /// Returns the product with another power.
    pub(crate) fn times(&self, other: &Self, parts: &mut Expressions) -> Self {
        let of = (&self.structure, self.is_odd != other.is_odd);
        Self::of(parts, self.size, of, |parts, (row, column)| {
            let pairs = (0..self.size).map(|k| (self.entry(row, k), other.entry(k, column)));
            let terms: Vec<_> = pairs.filter_map(|(x, y)| product(parts, x, y)).collect();
            sum(parts, terms)
        })
    }

    /// Returns the product JM of a matrix on Cⁿ with i: of the rows Re and Im the rows −Im and Re.
    pub(crate) fn times_i(&self, parts: &mut Expressions) -> Self {
        Self::of(
            parts,
            self.size,
            (&self.structure, !self.is_odd),
            |parts, (row, column)| match row % 2 {
                0 => self.entry(row + 1, column).map(|x| parts.negate(x)),
                _ => self.entry(row - 1, column),
            },
        )
    }

    /// Returns the trace of the product with another power, or `None` for zero.
    pub(crate) fn trace_with(&self, other: &Self, parts: &mut Expressions) -> Option<Expression> {
        let mut terms = Vec::new();
        for (i, j) in places(self.size) {
            // The same term stands at each image.
            let images = images(&self.structure, self.size, self.is_odd, (i, j));
            let mut places: Vec<Place> = images.into_iter().map(|(image, _)| image).collect();
            places.sort_unstable();
            places.dedup();
            if places.first() == Some(&(i, j))
                && let Some(term) = product(parts, self.entry(i, j), other.entry(j, i))
            {
                terms.push(scaled(parts, places.len() as f64, term));
            }
        }
        sum(parts, terms)
    }

    /// Returns the trace, or `None` for zero.
    pub(crate) fn trace(&self, parts: &mut Expressions) -> Option<Expression> {
        let diagonal = (0..self.size).filter_map(|i| self.entry(i, i)).collect();
        sum(parts, diagonal)
    }
}

/// Returns the places of a square matrix, row by row.
fn places(size: usize) -> impl Iterator<Item = Place> {
    (0..size).flat_map(move |row| (0..size).map(move |column| (row, column)))
}

/// Returns the product of two factors, or `None` for zero.
fn product(
    parts: &mut Expressions,
    x: Option<Expression>,
    y: Option<Expression>,
) -> Option<Expression> {
    x.zip(y).map(|(x, y)| parts.multiply(x, y))
}

/// Returns w x.
pub(crate) fn scaled(parts: &mut Expressions, weight: f64, x: Expression) -> Expression {
    if weight == 1.0 {
        x
    } else if weight == -1.0 {
        parts.negate(x)
    } else {
        let weight = parts.number(weight);
        parts.multiply(weight, x)
    }
}

/// Returns the sum of terms, or `None` if there are none.
pub(crate) fn sum(parts: &mut Expressions, terms: Vec<Expression>) -> Option<Expression> {
    terms.into_iter().reduce(|sum, term| parts.add(sum, term))
}
