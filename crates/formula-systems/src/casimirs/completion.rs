//! Casimirs that were found, completed by those of matrices and motions: [`Casimirs`].

use super::casimir::{Casimir, ScalarFunction};
use super::computed::computed_casimir::{Computation, ComputedCasimir};
use super::computed::cyclic_vector::CyclicVector;
use super::computed::matrix_of_momenta::MatrixOfMomenta;
use super::computed::power_trace::PowerTrace;
use super::computed::wedge_square::WedgeSquare;
use super::matrices::formulas::InvariantFormulas;
use super::matrices::invariant::Invariant;
use super::matrices::matrix_algebra::{MatrixAlgebra, Structure};
use super::motions::motion_algebra::MotionAlgebra;
use super::motions::wedge_formulas::WedgeFormulas;
use super::motions::wedge_product::WedgeProduct;
use super::span::Span;
use super::summand::Summand;
use core::ops::Range;
use lie_poisson_formulas::{PolynomialCasimirs, Vocabulary, generic_point};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

/// Independent Casimirs in the order of their degrees, and how many more there are.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Casimirs {
    pub(crate) all: Vec<(u8, Casimir)>,
    pub(crate) missing: usize,
}

impl Casimirs {
    /// Returns those that a search has found.
    pub(crate) fn found(found: &PolynomialCasimirs) -> Self {
        let all = found
            .degrees()
            .iter()
            .copied()
            .zip(found.formulas().iter().cloned().map(Casimir::from));
        Self { all: all.collect(), missing: found.missing() }
    }

    /// Returns these and, until none is missing, the invariants of the summands whose Casimirs are known, as far as none is a
    /// function of the others.
    pub(crate) fn completed(mut self, summands: &[Summand], names: &Vocabulary) -> Self {
        let point = generic_point(names.coordinates().dimension(), 0);
        for summand in summands {
            match summand {
                _ if self.missing == 0 => break,
                Summand::Matrices(algebra) => self.add_traces(algebra, names, &point),
                Summand::Motions(algebra) => self.add_wedge_products(algebra, names, &point),
                Summand::Volumes(algebra) => self.add_determinant(algebra, names, &point),
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
            let Ok(degree) = u8::try_from(invariant.degree()) else { continue };
            let formula = formulas.formula(invariant).map(Casimir::from);
            let casimir = formula.unwrap_or_else(|| {
                let form = match &algebra.structure {
                    Structure::Form(form) => Arc::clone(form),
                    _ => Arc::default(),
                };
                let trace = PowerTrace { matrix: MatrixOfMomenta::new(&duals), invariant, form };
                let text = formulas.text(invariant);
                computed(Computation::Matrix(trace), algebra.places(), point, text)
            });
            self.all.push((degree, casimir));
            self.missing -= 1;
            span.add(direction);
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
            let formula = formulas.formula(product).map(Casimir::from);
            let casimir = formula.unwrap_or_else(|| {
                let square = WedgeSquare { form: Arc::clone(algebra.form()), product };
                let text = formulas.text(product);
                computed(Computation::Wedge(square), algebra.places(), point, text)
            });
            self.add_if_apart(product.degree(), casimir, (algebra.places(), point), &mut span);
        }
    }

    /// Adds the invariant of sl(n, R) ⋉ Rⁿ.
    fn add_determinant(&mut self, algebra: &MatrixAlgebra, names: &Vocabulary, point: &[f64]) {
        let Some(duals) = algebra.duals() else { return };
        let (rotations, n) = (algebra.places(), algebra.size());
        let (places, count) = (rotations.start..rotations.end + n, rotations.len());
        let determinant = CyclicVector { matrix: MatrixOfMomenta::new(&duals), rotations: count };
        let degree = determinant.degree();
        let mut groups = names.coordinates().groups();
        let own = groups.find(|(_, group)| group.start == rotations.end);
        let vector = own.map_or_else(|| "Gamma".into(), |(name, _)| name.to_owned());
        let text = CyclicVector::text(&vector, n);
        let casimir = computed(Computation::Cyclic(determinant), places.clone(), point, text);
        let mut span = self.span(places.clone(), point);
        self.add_if_apart(degree, casimir, (places, point), &mut span);
    }

    /// Adds a Casimir of so many coordinates unless it is a function of the others.
    fn add_if_apart(
        &mut self,
        degree: usize,
        casimir: Casimir,
        (places, point): (Range<usize>, &[f64]),
        span: &mut Span,
    ) {
        let slopes = direction(&casimir, places, point);
        let direction = slopes.and_then(|slopes| span.apart(slopes));
        if let (Ok(degree), Some(direction)) = (u8::try_from(degree), direction) {
            self.all.push((degree, casimir));
            self.missing -= 1;
            span.add(direction);
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

/// Returns a Casimir that is computed from the coordinates at some places.
fn computed(
    computation: Computation,
    places: Range<usize>,
    point: &[f64],
    text: String,
) -> Casimir {
    ComputedCasimir { computation, places, dimension: point.len(), text }.into()
}

/// Returns the direction of a differential with respect to some coordinates, or `None` if it is zero, as for a Casimir of
/// another summand.
fn direction(casimir: &Casimir, places: Range<usize>, point: &[f64]) -> Option<DVector<f64>> {
    let slopes = ScalarFunction::differential_at(casimir, point);
    let own = DVector::from_column_slice(slopes.get(places)?);
    let size = own.norm();
    (size > 0.0).then(|| own / size)
}
