//! Casimirs that were found, completed by those of matrices and motions: [`Casimirs`].

use super::formulas::InvariantFormulas;
use super::invariant::Invariant;
use super::matrix_algebra::MatrixAlgebra;
use super::motions::motion_algebra::MotionAlgebra;
use super::motions::wedge_formulas::WedgeFormulas;
use super::motions::wedge_product::WedgeProduct;
use super::span::Span;
use super::summand::Summand;
use core::ops::Range;
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

    /// Returns these and, until none is missing, the invariants of the summands whose Casimirs are known, as far as none is a
    /// function of the others or larger than a formula may be.
    pub(crate) fn completed(mut self, summands: &[Summand], names: &Vocabulary) -> Self {
        let point = generic_point(names.coordinates().dimension());
        for summand in summands {
            match summand {
                _ if self.missing == 0 => break,
                Summand::Matrices(algebra) => self.add_traces(algebra, names, &point),
                Summand::Motions(algebra) => self.add_wedge_products(algebra, names, &point),
            }
        }
        self.all.sort_by_key(|(degree, _)| *degree);
        self
    }

    /// Adds the invariants of an algebra of matrices.
    fn add_traces(&mut self, algebra: &MatrixAlgebra, names: &Vocabulary, point: &[f64]) {
        let Some(duals) = algebra.duals() else { return };
        let own = point.get(algebra.places()).unwrap_or_default();
        let zero = DMatrix::zeros(algebra.size(), algebra.size());
        let x = own.iter().zip(&duals).fold(zero, |sum, (mu, dual)| sum + dual * *mu);
        let mut span = self.span(algebra.places(), point);
        let mut formulas = InvariantFormulas::new(algebra, &duals, names);
        for invariant in Invariant::all(algebra) {
            if self.missing == 0 {
                break;
            }
            let direction = invariant.direction(&x, &duals);
            // Whether it is a function of the others is known before its formula, which takes longer.
            let Some(direction) = direction.and_then(|slopes| span.apart(slopes)) else { continue };
            let (degree, formula) = (u8::try_from(invariant.degree()), formulas.formula(invariant));
            if let (Ok(degree), Some(formula)) = (degree, formula) {
                self.all.push((degree, formula));
                self.missing -= 1;
                span.add(direction);
            }
        }
    }

    /// Adds the invariants of so(p, q) ⋉ Rⁿ.
    fn add_wedge_products(&mut self, algebra: &MotionAlgebra, names: &Vocabulary, point: &[f64]) {
        let mut span = self.span(algebra.places(), point);
        let mut formulas = WedgeFormulas::new(algebra, names);
        for product in WedgeProduct::all(algebra.size()) {
            if self.missing == 0 {
                break;
            }
            let Some(formula) = formulas.formula(product) else { continue };
            let slopes = direction(&formula, algebra.places(), point);
            let direction = slopes.and_then(|slopes| span.apart(slopes));
            if let (Ok(degree), Some(direction)) = (u8::try_from(product.degree()), direction) {
                self.all.push((degree, formula));
                self.missing -= 1;
                span.add(direction);
            }
        }
    }

    /// Returns the space of the differentials at a point with respect to the coordinates of a summand.
    fn span(&self, places: Range<usize>, point: &[f64]) -> Span {
        let mut span = Span::default();
        for (_, casimir) in &self.all {
            let slopes = direction(casimir, places.clone(), point);
            if let Some(direction) = slopes.and_then(|slopes| span.apart(slopes)) {
                span.add(direction);
            }
        }
        span
    }
}

/// Returns the direction of a differential with respect to some coordinates, or `None` if it is zero, as for a Casimir of
/// another summand.
fn direction(casimir: &Formula, places: Range<usize>, point: &[f64]) -> Option<DVector<f64>> {
    let slopes = casimir.differential_at(point);
    let own = DVector::from_column_slice(slopes.get(places)?);
    let size = own.norm();
    (size > 0.0).then(|| own / size)
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
