//! A Casimir of a summand that is computed: [`ComputedCasimir`].

use super::cyclic_vector::CyclicVector;
use super::power_trace::PowerTrace;
use super::wedge_square::WedgeSquare;
use core::fmt;
use core::ops::Range;

/// An invariant of the coordinates of a summand.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Computation {
    Matrix(PowerTrace),
    Wedge(WedgeSquare),
    Cyclic(CyclicVector),
}

/// A Casimir that is computed from the coordinates of a summand, with the text that says what it is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ComputedCasimir {
    pub(crate) computation: Computation,
    /// The places of the coordinates of the summand, and the number of all coordinates.
    pub(crate) places: Range<usize>,
    pub(crate) dimension: usize,
    pub(crate) text: String,
}

impl ComputedCasimir {
    /// Returns the value, or NaN if there are fewer or more coordinates.
    pub(crate) fn value_at(&self, mu: &[f64]) -> f64 {
        match (mu.len() == self.dimension, mu.get(self.places.clone())) {
            (true, Some(own)) => match &self.computation {
                Computation::Matrix(trace) => trace.value(own),
                Computation::Wedge(square) => square.value(own),
                Computation::Cyclic(determinant) => determinant.value(own),
            },
            _ => f64::NAN,
        }
    }

    /// Writes the derivatives, or NaN if there are fewer or more coordinates.
    pub(crate) fn write_differential(&self, mu: &[f64], slopes: &mut [f64]) {
        let own = mu.get(self.places.clone()).filter(|_| mu.len() == self.dimension);
        let Some(own) = own else { return slopes.fill(f64::NAN) };
        slopes.fill(0.0);
        let mut found = vec![0.0; own.len()];
        match &self.computation {
            Computation::Matrix(trace) => trace.add_slopes(own, &mut found),
            Computation::Wedge(square) => square.add_slopes(own, &mut found),
            Computation::Cyclic(determinant) => determinant.add_slopes(own, &mut found),
        }
        slopes.iter_mut().skip(self.places.start).zip(found).for_each(|(slope, x)| *slope = x);
    }
}

impl fmt::Display for ComputedCasimir {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(&self.text)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::algebras::system_algebra::SystemAlgebra;
    use crate::casimirs::casimir::Casimir;
    use crate::casimirs::computed::matrix_of_momenta::MatrixOfMomenta;
    use crate::casimirs::matrices::formulas::InvariantFormulas;
    use crate::casimirs::matrices::invariant::Invariant;
    use crate::casimirs::matrices::matrix_algebra::Structure;
    use crate::casimirs::motions::wedge_formulas::WedgeFormulas;
    use crate::casimirs::motions::wedge_product::WedgeProduct;
    use crate::casimirs::summand::Summand;
    use lie_poisson_formulas::{Formula, Parameters, generic_point};
    use std::sync::Arc;

    /// Returns the invariants of an algebra that is one summand, with their formulas.
    fn both(text: &str) -> Vec<(Formula, Computation)> {
        let algebra = SystemAlgebra::named(text).unwrap();
        let names = algebra.vocabulary(&Parameters::new()).unwrap();
        match &algebra.summands[..] {
            [Summand::Matrices(own)] => {
                let duals = own.duals().unwrap();
                let mut formulas = InvariantFormulas::new(own, &duals, &names);
                let form = match &own.structure {
                    Structure::Form(form) => Arc::clone(form),
                    _ => Arc::default(),
                };
                let of = |invariant| {
                    let (matrix, form) = (MatrixOfMomenta::new(&duals), Arc::clone(&form));
                    let trace = PowerTrace { matrix, invariant, form };
                    Some((formulas.formula(invariant)?, Computation::Matrix(trace)))
                };
                // Traces that vanish on the algebra have no formula that counts.
                let respects = matches!(own.structure, Structure::Form(_) | Structure::Symplectic);
                let counts = |invariant: &Invariant| match invariant {
                    Invariant::Trace(k) => *k > 1 && (k.is_multiple_of(2) || !respects),
                    Invariant::TurnedTrace(k) => *k > 1,
                    Invariant::Pfaffian(_) => true,
                };
                Invariant::all(own).into_iter().filter(counts).filter_map(of).collect()
            }
            [Summand::Motions(own)] => {
                let mut formulas = WedgeFormulas::new(own, &names);
                let of = |product| {
                    let square = WedgeSquare { form: Arc::clone(own.form()), product };
                    Some((formulas.formula(product)?, Computation::Wedge(square)))
                };
                WedgeProduct::all(own.size()).into_iter().filter_map(of).collect()
            }
            _ => Vec::new(),
        }
    }

    /// What is computed is what is written, with its derivatives, where both are possible.
    #[test]
    fn computed_casimirs_are_those_of_their_formulas() {
        for (text, count) in [
            ("so(6)", 4),
            ("so(3,4)", 3),
            ("so(2,4)", 4),
            ("su(4)", 3),
            ("sl(4,R)", 3),
            ("gl(3)", 2),
            ("sp(6,R)", 3),
            ("se(5)", 3),
            ("so(3,3) ⋉ R6", 3),
            ("so(1,6) ⋉ R7", 4),
        ] {
            let all = both(text);
            assert_eq!(all.len(), count, "{text}");
            for (formula, computation) in all {
                let dimension = formula.dimension();
                let text = format!("{text}: {formula}");
                let casimir = Casimir::from(ComputedCasimir {
                    computation,
                    places: 0..dimension,
                    dimension,
                    text: text.clone(),
                });
                for sample in 1..4 {
                    let mu = generic_point(dimension, sample);
                    let slopes = formula.differential_at(&mu);
                    let terms: f64 = slopes.iter().zip(&mu).map(|(x, y)| (x * y).abs()).sum();
                    let largest = slopes.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                    let apart = (casimir.value_at(&mu) - formula.value_at(&mu)).abs();
                    // some hundred roundings of the terms of the sums
                    assert!(apart <= 1e-13 * terms, "{text} {apart:e}");
                    for (own, slope) in casimir.differential_at(&mu).iter().zip(&slopes) {
                        assert!((own - slope).abs() <= 1e-12 * largest, "{text} {own} {slope}");
                    }
                    // control
                    assert!(
                        casimir.value_at(&generic_point(dimension, sample + 1))
                            != casimir.value_at(&mu)
                    );
                }
                let more = vec![1.0; dimension + 1];
                assert!(
                    casimir.value_at(&more).is_nan() && casimir.differential_at(&more)[0].is_nan()
                );
            }
        }
    }

    /// det(Γ, ΓX, ΓX²) for n = 3, and for n = 4, with the derivatives.
    #[test]
    fn determinants_are_those_of_their_rows() {
        for (text, n) in [("sl(3,R) ⋉ R3", 3), ("sl(4,R) ⋉ R4", 4)] {
            let algebra = SystemAlgebra::named(text).unwrap();
            let Some(Summand::Volumes(own)) = algebra.summands.first() else { unreachable!() };
            let (duals, dimension) = (own.duals().unwrap(), algebra.dimension());
            let cyclic =
                CyclicVector { matrix: MatrixOfMomenta::new(&duals), rotations: n * n - 1 };
            assert_eq!(cyclic.degree(), n * (n + 1) / 2);
            for sample in 1..4 {
                let mu = generic_point(dimension, sample);
                let (x, gamma) = mu.split_at(n * n - 1);
                let matrix = cyclic.matrix.at(x);
                let first = nalgebra::RowDVector::from_row_slice(gamma);
                let rows = core::iter::successors(Some(first), |row| Some(row * &matrix)).take(n);
                let value = nalgebra::DMatrix::from_rows(&rows.collect::<Vec<_>>()).determinant();
                assert!((cyclic.value(&mu) / value - 1.0).abs() < 1e-12, "{text} {value}");
                let mut slopes = vec![0.0; dimension];
                cyclic.add_slopes(&mu, &mut slopes);
                for (i, slope) in slopes.iter().enumerate() {
                    let width = 1e-5;
                    let at = |width: f64| {
                        let mut moved = mu.clone();
                        moved[i] += width;
                        cyclic.value(&moved)
                    };
                    let quotient = (at(width) - at(-width)) / (2.0 * width);
                    // truncation of order width², and round-off ε/width
                    assert!((quotient - slope).abs() < 1e-7 * value.abs(), "{text} {i} {slope}");
                }
            }
            // where Γ is no cyclic vector the value is 0, and so are the derivatives if it vanishes
            let mut slopes = vec![0.0; dimension];
            cyclic.add_slopes(&vec![0.0; dimension], &mut slopes);
            assert!(cyclic.value(&vec![0.0; dimension]) == 0.0 && slopes.iter().all(|x| *x == 0.0));
        }
    }
}
