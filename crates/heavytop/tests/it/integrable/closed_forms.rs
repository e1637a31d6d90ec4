//! The closed-form solutions of Euler's and Lagrange's tops against the Gauss method of order 16.

use collective_integrators::{Collective, RungeKutta, Start};
use heavytop::{EulerSolution, HeavyTop, LagrangeNutation, RigidBody, SpinorRealisation};
use lie_poisson::{Covector, Se3Dual, larger};
use momentum_map::HOPF;
use nalgebra::Vector3;
use proptest::prelude::*;

fn vector(range: core::ops::Range<f64>) -> impl Strategy<Value = Vector3<f64>> {
    [range.clone(), range.clone(), range].prop_map(Vector3::from)
}

/// Returns the largest distance from the closed form at multiples of 0.2 up to t = 10.
fn euler_error(inertia: Vector3<f64>, start: Vector3<f64>) -> f64 {
    let body = RigidBody::new(inertia).unwrap();
    let exact = EulerSolution::new(&body, start).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(8).unwrap(), HOPF, body);
    let trajectory = gauss.trajectory(&Covector(start), 0.05).unwrap().take(201).step_by(4);
    trajectory.fold(0.0, |worst: f64, sample| {
        let sample = sample.unwrap();
        larger(worst, (sample.momentum.0 - exact.at(sample.time)).norm())
    })
}

/// Returns Π₃ for which (Π₁, Π₂, ±Π₃) is on the separatrix, Π₃²(I₃ − I₂)/I₃ = Π₁²(I₂ − I₁)/I₁, up to rounding.
fn on_the_separatrix(i: Vector3<f64>, x: f64) -> f64 {
    x * ((i.y - i.x) * i.z / ((i.z - i.y) * i.x)).sqrt()
}

/// Draws moments and a start: anywhere; on the separatrix; at a turning point of a component, which is zero there.
fn euler_motion() -> impl Strategy<Value = (Vector3<f64>, Vector3<f64>)> {
    let free = (vector(1.0..1.9), vector(-1.5..1.5));
    let separatrix =
        (1.0..1.2, 1.25..1.4, 1.45..1.9, vector(-1.0..1.0)).prop_map(|(a, b, c, pi)| {
            let inertia = Vector3::new(a, b, c);
            let z = on_the_separatrix(inertia, pi.x).copysign(pi.z);
            (inertia, Vector3::new(pi.x, pi.y, z))
        });
    let turning =
        (vector(1.0..1.9), vector(-1.5..1.5), 0..3_usize).prop_map(|(inertia, mut pi, i)| {
            pi[i] = 0.0;
            (inertia, pi)
        });
    prop_oneof![free, separatrix, turning]
}

/// Draws Π and Γ of Lagrange's top with I₁ = 2, m g l = 1.5: anywhere; at a turning point, Π⊥ ∥ Γ⊥; on the
/// separatrix, Π·Γ = Π₃ and |Π⊥|²/2I₁ = m g l (1 − Γ₃); next to the vertical.
fn lagrange_start() -> impl Strategy<Value = (Vector3<f64>, Vector3<f64>)> {
    let direction = || {
        vector(-1.0..1.0)
            .prop_filter("a direction", |v| v.xy().norm() > 0.1)
            .prop_map(|v: Vector3<f64>| v.normalize())
    };
    let free = (vector(-3.0..3.0), direction());
    let turning = (-2.0..2.0, -4.0..4.0, direction())
        .prop_map(|(a, spin, gamma)| (Vector3::new(a * gamma.x, a * gamma.y, spin), gamma));
    let separatrix =
        (-1.0..1.0, any::<bool>(), direction()).prop_map(|(fraction, up, gamma): (f64, _, _)| {
            let (drop, level) = (1.0 - gamma.z, gamma.xy().norm());
            let spin = fraction * (6.0 * (1.0 + gamma.z)).sqrt();
            let radial = spin * drop / level;
            let across = (6.0 * drop - radial * radial).max(0.0).sqrt();
            let across = if up { across } else { -across };
            let (x, y) = (gamma.x / level, gamma.y / level);
            (Vector3::new(radial * x - across * y, radial * y + across * x, spin), gamma)
        });
    let vertical = (-5.0..5.0, vector(-1e-3..1e-3), vector(-1e-3..1e-3), any::<bool>()).prop_map(
        |(spin, pi, gamma, up)| {
            let side = if up { 1.0 } else { -1.0 };
            (pi + Vector3::z() * spin, (gamma + Vector3::z() * side).normalize())
        },
    );
    prop_oneof![free, turning, separatrix, vertical]
}

/// Checks a motion of Euler's top.
fn euler_top_moves_so((inertia, start): (Vector3<f64>, Vector3<f64>)) -> Result<(), TestCaseError> {
    prop_assume!(start.norm() > 0.1);
    // Rounding errors of Gauss, some 1e-15, grow like e^{λt} next to the separatrix, with
    // λ = |Π|√((I₃−I₂)(I₂−I₁)/I₁I₃)/I₂ ≤ 0.8 for t ≤ 10.
    prop_assert!(euler_error(inertia, start) < 1e-11);
    Ok(())
}

/// Checks a motion of Lagrange's top.
fn lagrange_top_moves_so(
    axial: f64,
    (pi, gamma): (Vector3<f64>, Vector3<f64>),
) -> Result<(), TestCaseError> {
    let top = HeavyTop::lagrange(2.0, axial, 1.5).unwrap();
    let start = Se3Dual::new(pi, gamma);
    let nutation = LagrangeNutation::new(&top, &start).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(8).unwrap(), SpinorRealisation, top);
    for sample in gauss.trajectory(&start, 0.05).unwrap().take(201).step_by(4) {
        let sample = sample.unwrap();
        let error = (sample.momentum.0.1.z - nutation.height(sample.time)).abs();
        // Here, too, errors grow like e^{λt}, with λ = √(m g l/I₁) = 0.87 at most.
        prop_assert!(error < 1e-10, "t = {}: {error:e}", sample.time);
    }
    Ok(())
}

proptest! {
    #[test]
    fn euler_top(motion in euler_motion()) {
        euler_top_moves_so(motion)?;
    }

    #[test]
    fn lagrange_top(axial in 0.5..3.0, start in lagrange_start()) {
        lagrange_top_moves_so(axial, start)?;
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
fn a_wrong_parameter_of_the_closed_form_is_seen() {
    // The free body is compared with the solution of a body whose moments differ by 10⁻⁶.
    let body = RigidBody::new(Vector3::new(1.0, 1.4, 2.1)).unwrap();
    let other = RigidBody::new(Vector3::new(1.0, 1.4, 2.1 + 1e-6)).unwrap();
    let start = Vector3::new(0.2, -0.3, 1.5);
    let at = |body| EulerSolution::new(body, start).unwrap().at(10.0);
    assert!((at(&body) - at(&other)).norm() > 1e-7);
}
