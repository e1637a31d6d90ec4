//! Ranks and Casimirs of a table of rounded constants.

use super::balance::{Scales, shifted};
use super::near_null_space::near_null_space;
use crate::casimirs::bounds::LOW_DEGREE;
use crate::casimirs::bracket_table::BracketTable;
use crate::casimirs::monomials::{count, equations, monomials};
use crate::casimirs::polynomial::{Polynomial, generic_point};
use lie_poisson::StructureEntry;
use nalgebra::DMatrix;

/// The largest number of monomials for which a dense matrix is factored; this takes a second.
const MOST_MONOMIALS: usize = 1024;

/// The largest singular value of the Poisson tensor, relative to its largest one, that counts as zero.
const ZERO: f64 = 1e-10;

/// The rank of a matrix of rounded numbers, with the singular values that decide it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NumericRank {
    pub(crate) rank: usize,
    /// The largest singular value that counts as zero, and the smallest that does not, relative to the largest one.
    pub(crate) gap: [f64; 2],
}

/// A table in units of its own, in which the largest constant is ±1.
#[derive(Clone, Debug)]
pub(crate) struct NumericBrackets<'a> {
    table: BracketTable<f64>,
    scales: &'a Scales,
}

impl<'a> NumericBrackets<'a> {
    pub(crate) fn new(dimension: usize, constants: &[StructureEntry], scales: &'a Scales) -> Self {
        let kept = constants.iter().filter(|constant| !scales.is_rounding(constant));
        let entries = kept.map(|c| (c.i, c.j, c.k, scales.relative(c)));
        Self { table: BracketTable::new(dimension, entries), scales }
    }

    /// Returns the rank of the Poisson tensor at a generic point, which is the largest dimension of an orbit.
    pub(crate) fn generic_rank(&self) -> NumericRank {
        let n = self.table.dimension();
        let point = generic_point(n, 0);
        let tensor = DMatrix::from_fn(n, n, |i, j| self.table.poisson(i, j, &point));
        let values = tensor.singular_values();
        let largest = values.iter().copied().fold(0.0, f64::max);
        let relative = values.iter().map(|value| if largest > 0.0 { value / largest } else { 0.0 });
        let (zeros, others): (Vec<f64>, Vec<f64>) = relative.partition(|value| *value <= ZERO);
        let gap =
            [zeros.into_iter().fold(0.0, f64::max), others.iter().copied().fold(1.0, f64::min)];
        NumericRank { rank: others.len(), gap }
    }

    /// Returns a basis of the Casimirs of a degree, or `None` if there are too many monomials.
    pub(crate) fn invariants(&self, degree: u8) -> Option<Vec<Polynomial>> {
        let n = self.table.dimension();
        if degree > LOW_DEGREE || count(n, degree) > MOST_MONOMIALS {
            return None;
        }
        let monomials = monomials(n, degree);
        let space = near_null_space(&equations(&self.table, 0..n, &monomials), monomials.len());
        let polynomial = |vector: Vec<f64>| {
            let terms = monomials.iter().cloned().zip(vector).filter(|(_, entry)| *entry != 0.0);
            let exponents = |monomial: &[u8]| -> i32 {
                monomial
                    .iter()
                    .enumerate()
                    .map(|(i, &e)| i32::from(e) * self.scales.exponent(i))
                    .sum()
            };
            let terms: Vec<_> =
                terms.map(|(monomial, a)| (exponents(&monomial), monomial, a)).collect();
            // The coefficient of the monomial in the given coordinates, up to a common factor.
            let least = terms.iter().map(|(exponent, ..)| *exponent).min().unwrap_or(0);
            let terms = terms.into_iter().map(|(e, monomial, a)| (monomial, shifted(a, least - e)));
            Polynomial { terms: terms.collect() }
        };
        Some(space.into_iter().map(polynomial).collect())
    }
}
