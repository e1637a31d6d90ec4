//! The closed-form solutions against the Gauss method of order 16, and against the equations.
#![allow(clippy::unwrap_used)]

use collective_integrators::{Collective, RungeKutta, Start};
use heavytop::{EulerSolution, HeavyTop, LagrangeNutation, RigidBody, SpinorRealisation};
use lie_poisson::{Covector, Se3Dual, larger};
use momentum_map::HOPF;
use nalgebra::Vector3;
use proptest::prelude::*;

fn vector(range: core::ops::Range<f64>) -> impl Strategy<Value = Vector3<f64>> {
    [range.clone(), range.clone(), range].prop_map(Vector3::from)
}

/// The largest distance to the closed form at multiples of 0.2 up to t = 10.
fn euler_error(inertia: Vector3<f64>, start: Vector3<f64>) -> f64 {
    let body = RigidBody::new(inertia).unwrap();
    let exact = EulerSolution::new(&body, start);
    let gauss = Collective::new(RungeKutta::gauss(8).unwrap(), HOPF, body);
    let trajectory = gauss.trajectory(&Covector(start), 0.05).unwrap().take(201).step_by(4);
    trajectory.fold(0.0, |worst: f64, sample| {
        let sample = sample.unwrap();
        larger(worst, (sample.momentum.0 - exact.at(sample.time)).norm())
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn euler_top(inertia in vector(1.0..1.9), start in vector(-1.5..1.5)) {
        prop_assume!(start.norm() > 0.1);
        // Next to the separatrix errors of the initial phase grow like e^{λt}, λt ≤ 8 here.
        prop_assert!(euler_error(inertia, start) < 1e-10);
    }

    #[test]
    fn lagrange_top(
        axial in 0.5..3.0,
        pi in vector(-3.0..3.0),
        gamma in vector(-1.0..1.0),
    ) {
        prop_assume!(gamma.norm() > 0.2);
        let top = HeavyTop::lagrange(2.0, axial, 1.5).unwrap();
        let start = Se3Dual::new(pi, gamma.normalize());
        let nutation = LagrangeNutation::new(&top, &start).unwrap();
        let gauss = Collective::new(RungeKutta::gauss(8).unwrap(), SpinorRealisation, top);
        for sample in gauss.trajectory(&start, 0.05).unwrap().take(201).step_by(4) {
            let sample = sample.unwrap();
            let error = (sample.momentum.0.1.z - nutation.height(sample.time)).abs();
            // Close roots of the cubic are known to √ε alone.
            prop_assert!(error < 1e-7, "t = {}: {error:e}", sample.time);
        }
    }
}

#[test]
fn euler_top_in_every_order_of_moments_and_on_both_sides_of_the_separatrix() {
    let (a, b, c) = (1.0, 1.4, 2.1);
    let orders = [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]];
    for inertia in orders.map(Vector3::from) {
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                let mut start = Vector3::new(0.2, -0.3, 0.25);
                start[axis] = sign * 1.5;
                let error = euler_error(inertia, start);
                // Gauss-16 at this step leaves a few units of round-off per unit of time.
                assert!(error < 1e-12, "{inertia:?} {start:?} {error:e}");
            }
        }
    }
}

#[test]
fn euler_top_with_equal_moments_and_about_a_principal_axis() {
    let starts = [Vector3::new(0.3, -0.4, 1.2), Vector3::x(), -Vector3::y(), Vector3::z()];
    for start in starts {
        for inertia in [[1.0, 1.0, 1.0], [2.0, 2.0, 1.0], [1.0, 2.0, 2.0], [1.5, 1.0, 1.5]] {
            let error = euler_error(Vector3::from(inertia), start);
            assert!(error < 1e-13, "{inertia:?} {start:?} {error:e}");
        }
    }
    let rest =
        EulerSolution::new(&RigidBody::new(Vector3::new(1.0, 2.0, 2.5)).unwrap(), Vector3::zeros());
    assert_eq!(rest.at(3.0), Vector3::zeros());
}

#[test]
fn lagrange_top_at_a_generic_start_to_round_off() {
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0).unwrap();
    for (pi, gamma) in [
        (Vector3::new(0.5, 0.2, 3.0), Vector3::new(0.6, 0.0, 0.8)),
        (Vector3::new(-0.5, 1.2, 1.0), Vector3::new(0.0, 0.6, -0.8)),
    ] {
        let start = Se3Dual::new(pi, gamma);
        let nutation = LagrangeNutation::new(&top, &start).unwrap();
        let gauss = Collective::new(RungeKutta::gauss(8).unwrap(), SpinorRealisation, top);
        for sample in gauss.trajectory(&start, 0.05).unwrap().take(401) {
            let sample = sample.unwrap();
            let error = (sample.momentum.0.1.z - nutation.height(sample.time)).abs();
            assert!(error < 1e-12, "{error:e}");
        }
        let (low, high) = nutation.turning_points();
        assert!(-1.0 <= low && low < high && high <= 1.0);
    }
}

#[test]
fn the_upright_top_stays_upright() {
    // Stable or not: Γ₃ = 1 is a double root of the cubic.
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0).unwrap();
    for spin in [1.0, 5.0] {
        let start = Se3Dual::new(Vector3::z() * spin, Vector3::z());
        let nutation = LagrangeNutation::new(&top, &start).unwrap();
        for time in [0.0, 1.0, 17.0] {
            assert!((nutation.height(time) - 1.0).abs() < 1e-15);
        }
    }
}

#[test]
fn a_wrong_parameter_of_the_closed_form_is_seen() {
    // The free body against the solution of one whose moments differ by 10⁻⁶.
    let body = RigidBody::new(Vector3::new(1.0, 1.4, 2.1)).unwrap();
    let other = RigidBody::new(Vector3::new(1.0, 1.4, 2.1 + 1e-6)).unwrap();
    let start = Vector3::new(0.2, -0.3, 1.5);
    let (one, two) = (EulerSolution::new(&body, start), EulerSolution::new(&other, start));
    assert!((one.at(10.0) - two.at(10.0)).norm() > 1e-7);
    let kovalevskaya = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    assert!(LagrangeNutation::new(&kovalevskaya, &Se3Dual::new(start, Vector3::z())).is_err());
}
