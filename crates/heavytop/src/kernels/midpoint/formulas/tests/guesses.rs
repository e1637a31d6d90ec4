//! Guesses of a: their extrapolation and their bounds.

use super::{OneOfMany, members, top};
use crate::kernels::midpoint::formulas::GuessHistory;
use crate::kernels::midpoint::formulas::components::TopState;
use crate::kernels::midpoint::formulas::extrapolation::Extrapolation;
use crate::kernels::midpoint::formulas::guess::Guess;
use crate::kernels::midpoint::formulas::midpoint_parameters::{MidpointParameters, SQUARED_FLOOR};
use lie_poisson::{InstructionSet, Se3Dual};
use nalgebra::Vector3;

#[test]
fn polynomials_are_continued_by_as_many_values_as_are_known() {
    let mut past = Extrapolation::<[f64; 3]>::new([0.0; 3]);
    let values = |n: i32, degree: i32| {
        let x = f64::from(n) / 8.0 - 1.0;
        [x.powi(degree), -2.0 * x.powi(degree), 1.0]
    };
    assert_eq!(past.predict(|v| *v), None);
    for degree in 0..10 {
        past = Extrapolation::new([0.0; 3]);
        for n in 0..20 {
            past.push(|v| *v = values(n, degree));
            assert_eq!(past.newest(), &values(n, degree));
            let next = past.predict(|v| *v).unwrap();
            let error = (0..3).map(|i| (next[i] - values(n + 1, degree)[i]).abs());
            let error = error.fold(0.0, f64::max);
            // A polynomial through n + 1 values. The weights add up to 2¹⁰.
            assert_eq!(error < 1e-12, n >= degree, "{degree} {n}: {error:e}");
        }
    }
}

/// Returns the parameters of a top with moments and force in these units, and with h and |Γ| in them.
fn parameters(mass: f64, time: f64, vertical: f64) -> MidpointParameters<[f64; 3], f64> {
    let unit = mass / (time * time * vertical);
    let top = top(Vector3::new(1.5, 1.25, 0.5) * mass, Vector3::new(0.0, 3.0, 4.0) * unit);
    let square = 0.49 * vertical * vertical;
    MidpointParameters::gather(|_| top, |_| square, 0.125 * time)
}

#[test]
fn bounds_have_no_units() {
    let one = parameters(1.0, 1.0, 1.0);
    // ρ = 3, h²|γ||Γ|/I_min = 5·0.7/(64·0.5)
    let kick = (5.0_f64 * 0.7 / 32.0).powi(2);
    let close = |x: f64, expected: f64| (x / expected - 1.0).abs() < 1e-14;
    assert!(close(one.turning_rate * SQUARED_FLOOR, 2.0 * 18.0 * 18.0));
    assert!(close(one.kick_rate * SQUARED_FLOOR, 2.0 * kick * (5.0_f64 / 8.0).powi(2)));
    assert!(close(one.least_square, kick / 64.0));
    for exponents in [[60, 0, 0], [0, -40, 0], [0, 0, 50], [-60, 40, -20]] {
        let [mass, time, vertical] = exponents.map(|n| 2.0_f64.powi(n));
        let other = parameters(mass, time, vertical);
        let bounds = |p: &MidpointParameters<_, f64>| [p.turning_rate, p.kick_rate, p.least_square];
        for (x, expected) in bounds(&other).into_iter().zip(bounds(&one)) {
            assert!(close(x, expected), "{exponents:?}: {x:e} {expected:e}");
        }
    }
}

#[test]
fn only_round_off_counts_as_a_stall() {
    let OneOfMany(top, mu) = members()[3];
    let parameters = MidpointParameters::<[f64; 3], f64>::gather(|_| top, |_| 1.0, 0.02);
    let start = TopState::gather(|_| mu);
    let mut a = [0.0; 3];
    for _ in 0..50 {
        a = Guess::new(&parameters, &start, a).corrected();
    }
    let stalled = |part: f64, previous: f64| {
        let nearby = [a[0] * (1.0 + part), a[1], a[2]];
        Guess::new(&parameters, &start, nearby).stalled(&parameters, previous)
    };
    assert!(stalled(0.0, 0.0) && stalled(1e-15, 0.0));
    let converged = |part: f64| {
        let nearby = [a[0] * (1.0 + part), a[1], a[2]];
        Guess::new(&parameters, &start, nearby).converged(&parameters)
    };
    // The error after a correction is smaller by a factor of some hundredths.
    assert!(converged(1e-15) && !converged(1e-11) && !converged(1e-9));
    // Larger corrections, and those that still shrink, are no stall.
    assert!(!stalled(1e-11, 0.0) && !stalled(1e-9, 0.0) && !stalled(1e-15, 1.0));
}

/// The same bits change in two coordinates.
#[test]
fn a_step_from_another_point_is_begun_anew() {
    let OneOfMany(top, mu) = members()[3];
    let set = InstructionSet::detected();
    let next =
        |history: &mut GuessHistory, mu: &Se3Dual| history.step(&top, mu, 0.02, set).unwrap();
    let mut history = GuessHistory::new(&top);
    let mut end = mu;
    for _ in 0..20 {
        end = next(&mut history, &end).point;
    }
    let flipped = |x: f64| f64::from_bits(x.to_bits() ^ 1);
    let mut other = end;
    (other.0.1.x, other.0.1.y) = (flipped(end.0.1.x), flipped(end.0.1.y));
    let found = next(&mut history.clone(), &other);
    let expected = next(&mut GuessHistory::new(&top), &other);
    assert_eq!((found.point, found.iterations), (expected.point, expected.iterations));
    // Control: a step that continues the last one needs fewer guesses.
    assert!(next(&mut history, &end).iterations < expected.iterations);
}
