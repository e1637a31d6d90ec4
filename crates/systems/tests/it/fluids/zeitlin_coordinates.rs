//! Zeitlin's model on coordinates: its rate is that of the matrices, and its derivative that of a quadratic field.

use collective_integrators::{AnyState, VectorField};
use lie_poisson::{DualNumber, State};
use lie_poisson_systems::isospectral_flows::{CommutatorField, LargeSkewHermitian};
use lie_poisson_systems::{Zeitlin, ZeitlinCoordinates};
use proptest::prelude::*;

fn largest(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn sizes_and_states() -> impl Strategy<Value = (usize, Vec<f64>, Vec<f64>)> {
    let numbers = |n: usize| prop::collection::vec(-1.0..1.0_f64, n * n);
    (2..9_usize).prop_flat_map(move |n| (Just(n), numbers(n), numbers(n)))
}

proptest! {
    #[test]
    fn rates_are_those_of_matrices((n, w, _) in sizes_and_states(), rotation in -2.0..2.0) {
        let fluid = Zeitlin::new(n).unwrap().with_rotation(rotation).unwrap();
        let mut matrix = LargeSkewHermitian::zeros(n);
        matrix.set_coordinates(|i| w[i]);
        let expected = CommutatorField::new(fluid.clone()).at(&matrix);
        let expected: Vec<f64> = (0..n * n).map(|i| expected.coordinate(i)).collect();
        let rate = ZeitlinCoordinates(fluid).at(&AnyState::from_slice(&w));
        // Sums of some n products of numbers of order 1, over ħ = 2/√(N² − 1) of 1/4 and more.
        prop_assert!(largest(rate.as_slice(), &expected) < 1e-13 * n as f64);
        // Control: another rotation.
        let other = Zeitlin::new(n).unwrap().with_rotation(rotation + 1.0).unwrap();
        let other = ZeitlinCoordinates(other).at(&AnyState::from_slice(&w));
        prop_assert!(largest(other.as_slice(), &expected) > 1e-6 || n == 2);
    }

    /// The field is quadratic on a sphere at rest: DX(w)v = X(w + v) − X(w) − X(v), without a limit.
    #[test]
    fn derivatives_are_those_of_a_quadratic_field((n, w, v) in sizes_and_states()) {
        let field = ZeitlinCoordinates(Zeitlin::new(n).unwrap());
        let at = |x: &[f64]| field.at(&AnyState::from_slice(x)).as_slice().to_vec();
        let sum: Vec<f64> = w.iter().zip(&v).map(|(w, v)| w + v).collect();
        let expected: Vec<f64> =
            at(&sum).iter().zip(at(&w)).zip(at(&v)).map(|((sum, w), v)| sum - w - v).collect();
        let dual: Vec<DualNumber> = w.iter().zip(&v).map(|(w, v)| DualNumber::new(*w, *v)).collect();
        let rate = VectorField::<DualNumber>::at(&field, &AnyState::from_slice(&dual));
        let derivative: Vec<f64> = rate.as_slice().iter().map(|x| x.derivative()).collect();
        prop_assert!(largest(&derivative, &expected) < 1e-12);
    }
}

#[test]
fn other_dimensions_have_no_rate() {
    let field = ZeitlinCoordinates(Zeitlin::new(3).unwrap());
    let rate = field.at(&AnyState::from_slice(&[1.0; 8]));
    assert!(rate.as_slice().iter().all(|x| x.is_nan()));
}
