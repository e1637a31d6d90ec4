//! Casimirs that were found, completed by those of matrices: [`Casimirs`].

use super::formulas::InvariantFormulas;
use super::invariant::Invariant;
use super::matrix_algebra::MatrixAlgebra;
use super::span::Span;
use lie_poisson_formulas::{Formula, PolynomialCasimirs, Vocabulary};
use nalgebra::{DMatrix, DVector};

/// Independent Casimirs in the order of their degrees, and how many more there are.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Casimirs {
    pub(crate) all: Vec<(u8, Formula)>,
    pub(crate) missing: usize,
}

impl Casimirs {
    /// Returns those that a search has found.
    pub(crate) fn found(found: &PolynomialCasimirs) -> Self {
        let all = found.degrees().iter().copied().zip(found.formulas().iter().cloned());
        Self { all: all.collect(), missing: found.missing() }
    }

    /// Returns these and, until none is missing, the invariants of the summands that are algebras of matrices, as far as
    /// none is a function of the others or larger than a formula may be.
    pub(crate) fn completed(mut self, summands: &[MatrixAlgebra], names: &Vocabulary) -> Self {
        for summand in summands {
            if self.missing == 0 {
                break;
            }
            self.complete(summand, names);
        }
        self.all.sort_by_key(|(degree, _)| *degree);
        self
    }

    /// Adds the invariants of a summand.
    fn complete(&mut self, summand: &MatrixAlgebra, names: &Vocabulary) {
        let Some(duals) = summand.duals() else { return };
        let point = generic_point(names.coordinates().dimension());
        let own = point.get(summand.places()).unwrap_or_default();
        let zero = DMatrix::zeros(summand.size(), summand.size());
        let x = own.iter().zip(&duals).fold(zero, |sum, (mu, dual)| sum + dual * *mu);
        let mut span = self.span(summand, &point);
        let mut formulas = InvariantFormulas::new(summand, &duals, names);
        for invariant in Invariant::all(summand) {
            if self.missing == 0 {
                break;
            }
            let direction = invariant.direction(&x, &duals);
            let Some(direction) = direction.and_then(|slopes| span.apart(slopes)) else { continue };
            let (degree, formula) = (u8::try_from(invariant.degree()), formulas.formula(invariant));
            if let (Ok(degree), Some(formula)) = (degree, formula) {
                self.all.push((degree, formula));
                self.missing -= 1;
                span.add(direction);
            }
        }
    }

    /// Returns the space of the differentials at a point with respect to the coordinates of a summand.
    fn span(&self, summand: &MatrixAlgebra, point: &[f64]) -> Span {
        let mut span = Span::default();
        for (_, casimir) in &self.all {
            let slopes = casimir.differential_at(point);
            let own = slopes.get(summand.places()).unwrap_or_default();
            let own = DVector::from_column_slice(own);
            let size = own.norm();
            // Those of other summands are zero.
            if size > 0.0
                && let Some(direction) = span.apart(own / size)
            {
                span.add(direction);
            }
        }
        span
    }
}

/// Returns a point whose coordinates, between −1 and 1, behave like random ones and are the same in every run.
///
/// They obey no linear recurrence, by which they would make matrices of small rank, as sines of i² do: 22 is nearly 7π.
fn generic_point(dimension: usize) -> Vec<f64> {
    let next = |x: &f64| Some(1.0 - 2.0 * x * x);
    core::iter::successors(Some(0.3), next).take(dimension).collect()
}

#[cfg(test)]
mod tests {
    use super::generic_point;
    use nalgebra::DMatrix;

    /// Square matrices of the coordinates are far from singular; that of sines of i² with 11 rows is not.
    #[test]
    fn matrices_of_generic_coordinates_have_full_rank() {
        let condition = |of: &dyn Fn(usize) -> Vec<f64>, n: usize| {
            let values = DMatrix::from_vec(n, n, of(n * n)).singular_values();
            values.min() / values.max()
        };
        let sines = |count: usize| (1..=count).map(|i| ((i * i) as f64).sin()).collect();
        assert!((2..17).all(|n| condition(&generic_point, n) > 1e-3));
        assert!(condition(&sines, 11) < 1e-4);
    }
}
