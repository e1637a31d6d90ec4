//! Proposition 2.2 and Theorem 4.1(i): every (Π, Γ) with Γ ≠ 0 has a lift; §5.2: the paper's own.

use heavytop::{SpinorPoint, SpinorRealisation};
use lie_poisson::{Covector, DefaultLanes, Lanes, Pair, Real, Se3Dual, Vector, map_coordinates};
use momentum_map::{Cotangent, FibreSymmetry, HOPF, Lift, LiftError, PoissonMap, SourcePoint};
use nalgebra::{Matrix3, Matrix3x4, Vector2, Vector3, Vector4};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{
    assert_close, assert_near, momentum_with_vertical, persistent, point, relative_error, tops,
};

/// The round-off of square roots and a dozen products.
const ROUND_OFF: f64 = 1e-14;

/// Returns the matrix A(p) of the proof of Proposition 2.2: Π = A(p) q.
#[rustfmt::skip]
fn matrix_a(p: &Vector4<f64>) -> Matrix3x4<f64> {
    Matrix3x4::new( p[3], -p[2],  p[1], -p[0],
                   -p[2], -p[3],  p[0],  p[1],
                    p[1], -p[0], -p[3],  p[2]) * 0.5
}

fn real(z: &SpinorPoint) -> (Vector4<f64>, Vector4<f64>) {
    (map_coordinates(&z.q, |x| x), map_coordinates(&z.p, |x| x))
}

/// Returns the relative errors of Π and Γ, each against its own size.
fn errors(a: &Se3Dual, b: &Se3Dual) -> (f64, f64) {
    (relative_error(&a.0.0, &b.0.0), relative_error(&a.0.1, &b.0.1))
}

fn check(mu: &Se3Dual) -> Result<(), TestCaseError> {
    let z = SpinorRealisation.lift(mu).map_err(|e| TestCaseError::fail(e.to_string()))?;
    let (pi, gamma) = errors(&SpinorRealisation.apply(&z), mu);
    prop_assert!(pi <= ROUND_OFF && gamma <= ROUND_OFF, "{pi:e} {gamma:e} at {mu:?}");

    let (q, p) = real(&z);
    let size = q.norm() * p.norm();
    prop_assert!(p.dot(&q).abs() <= ROUND_OFF * size, "⟨p, q⟩ = {:e}", p.dot(&q));
    let least = matrix_a(&p).transpose() * mu.0.0 * (4.0 / p.norm_squared());
    prop_assert!(relative_error(&q, &least) <= ROUND_OFF);
    Ok(())
}

proptest! {
    #![proptest_config(persistent())]

    #[test]
    fn the_lift_is_a_section_of_least_norm(mu in momentum_with_vertical()) {
        check(&mu)?;
    }

    /// The matrix satisfies A Aᵀ = (‖p‖²/4) I, and Π = A(p) q.
    #[test]
    fn a_is_a_multiple_of_an_isometry(z in point::<SpinorPoint>()) {
        let (q, p) = real(&z);
        let a = matrix_a(&p);
        let expected = Matrix3::from_diagonal_element(0.25 * p.norm_squared());
        assert_near(&(a * a.transpose()), &expected, 1e-14);
        assert_near(&SpinorRealisation.apply(&z).0.0, &(a * q), 1e-14);
    }

    /// One slide along the fibre leaves at most a third of the way to the least norm, where χ is √2 times as long or
    /// longer. From far away, a rounding error of the way is left.
    #[test]
    fn sliding_leads_towards_the_least_norm(mu in momentum_with_vertical(), b in -20.0..20.0_f64) {
        let z = SpinorRealisation.lift(&mu).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let moved = SpinorRealisation.flow(0, b, &z);
        let back = moved + SpinorRealisation.gauge(&moved);
        let (least, length) = (z.q.norm(), b.abs() * z.p.0.norm());
        if length < 0.999 * least {
            prop_assert_eq!(back, moved);
            return Ok(());
        }
        prop_assume!(length > 1.001 * least);
        prop_assert!((back.q - z.q).norm() <= length / 3.0 + ROUND_OFF * moved.q.norm());
        prop_assert!((SpinorRealisation.apply(&back) - mu).max_abs() <= ROUND_OFF * (1.0 + mu.max_abs() + length * z.p.0.norm()));
    }

    #[test]
    fn the_lift_with_a_given_re_chi1(
        mu in momentum_with_vertical(), size in 0.01..100.0_f64, re_chi1 in -3.0..3.0_f64,
    ) {
        let Covector(Pair(pi, gamma)) = mu;
        let unit = gamma / gamma.amax();
        let gamma = unit.normalize() * size;
        // The momenta stay away from Γ ∥ −e₃, where ψ₁ = 0.
        let gamma = if gamma.z < -0.5 * size { -gamma } else { gamma };
        let mu = Se3Dual::new(pi, gamma);
        let z = SpinorRealisation
            .lift_with(&mu, re_chi1)
            .map_err(|e| TestCaseError::fail(e.to_string()))?;
        assert_close(z.q.x.re, re_chi1, 1e-13);
        prop_assert!(z.p.0.x.im.abs() <= 1e-15 * gamma.norm() && z.p.0.x.re > 0.0);
        // χ is up to 1e3 long here, and cancels in Π.
        assert_near(&SpinorRealisation.apply(&z).0.0, &pi, 1e-12);
        assert_near(&SpinorRealisation.apply(&z).0.1, &gamma, 1e-14);
    }

    #[test]
    fn the_hopf_lift_is_a_section(pi in momentum_with_vertical()) {
        let pi = Covector(pi.0.1);
        let z = HOPF.lift(&pi).map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert!(relative_error(&HOPF.apply(&z), &pi) <= ROUND_OFF);
    }
}

/// Special directions, each with Π = 0 and with Π along and across.
#[test]
fn the_poles_and_the_equator() -> Result<(), TestCaseError> {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    for gamma in axes.iter().flat_map(|axis| [*axis, -axis, axis * 1e-100, axis * -1e100]) {
        check(&Se3Dual::new(Vector3::zeros(), gamma))?;
        for pi in axes {
            check(&Se3Dual::new(pi * 3.0, gamma))?;
        }
    }
    Ok(())
}

/// Γ = 0 and NaN have no lift, and neither has one bad lane among good ones.
#[test]
fn what_has_no_lift_is_an_error() {
    let (pi, nan) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.0, f64::NAN, 1.0));
    let infinite = Vector3::new(f64::INFINITY, 0.0, 0.0);
    for mu in [
        Se3Dual::new(pi, Vector3::zeros()),
        Se3Dual::new(Vector3::zeros(), Vector3::zeros()),
        Se3Dual::new(pi, nan),
        Se3Dual::new(nan, pi),
        Se3Dual::new(infinite, pi),
        Se3Dual::new(pi, infinite),
    ] {
        assert!(SpinorRealisation.lift(&mu).is_err(), "{mu:?}");
        assert!(SpinorRealisation.lift_with(&mu, 1.0).is_err(), "{mu:?}");
    }
    for pi in [Vector3::zeros(), nan, infinite] {
        assert!(HOPF.lift(&Covector(pi)).is_err());
    }
    let down = Se3Dual::new(pi, -Vector3::z());
    assert!(SpinorRealisation.lift(&down).is_ok());
    assert!(SpinorRealisation.lift_with(&down, 1.0).is_err());

    let lanes = |third: f64| DefaultLanes::load(&[1.0, 0.5, third, -1.0]);
    let zero = Vector3::from_element(DefaultLanes::from_f64(0.0));
    let gamma = |third| Vector3::new(zero.x, zero.x, lanes(third));
    assert!(SpinorRealisation.lift(&Se3Dual::new(zero, gamma(2.0))).is_ok());
    assert!(SpinorRealisation.lift(&Se3Dual::new(zero, gamma(0.0))).is_err());
}

/// Returns χ(0) and ψ(0) of §5.2.
fn paper_point() -> SpinorPoint {
    let (r2, r3, r6) = (2.0_f64.sqrt(), 3.0_f64.sqrt(), 6.0_f64.sqrt());
    let c = Complex::new;
    let chi =
        Vector2::new(c(1.0, -(r2 + 3.0 * r6)), c(-1.0 + 12.0 * r2 + r3, -2.0 * r6) / (1.0 + r3));
    let psi = Vector2::new(c(r3 + 1.0, 0.0), c(r3 - 1.0, 0.0)) / c(2.0 * r2, 0.0);
    Cotangent::new(chi, Covector(psi))
}

/// The paper's initial condition is a lift of (Π(0), Γ(0)), and is the one with Re χ₁ = 1 and ψ
/// real, up to the rounding of numbers of size 10.
#[test]
fn the_initial_condition_of_the_paper() -> Result<(), LiftError> {
    assert_near(&SpinorRealisation.apply(&paper_point()), &tops::paper_start(), ROUND_OFF);
    let lifted = SpinorRealisation.lift_with(&tops::paper_start(), 1.0)?;
    assert_near(&lifted, &paper_point(), ROUND_OFF);
    // The least lift is another one, on the same fibre.
    let least = SpinorRealisation.lift(&tops::paper_start())?;
    assert!((least - lifted).max_abs() > 0.1);
    // The slide is bψ with a power of two for b, until χ is less than √2 times as long as the least.
    let mut near = SpinorRealisation.flow(0, 20.0, &lifted);
    for _ in 0..4 {
        near += SpinorRealisation.gauge(&near);
    }
    assert!(near.q.norm() < 2_f64.sqrt() * least.q.norm());
    assert_near(&SpinorRealisation.apply(&near), &tops::paper_start(), ROUND_OFF);
    Ok(())
}

/// Erratum 5: Re χ₁ = 1 leaves one parameter of the fibre free. Here are two lifts with it; only
/// one of them has ψ real.
#[test]
fn re_chi1_alone_does_not_fix_the_lift() {
    let other = SpinorRealisation.flow(1, 0.4, &paper_point());
    let other = SpinorRealisation.flow(0, (1.0 - other.q.x.re) / other.p.0.x.re, &other);
    assert_close(other.q.x.re, 1.0, 1e-15);
    assert_near(&SpinorRealisation.apply(&other), &tops::paper_start(), ROUND_OFF);
    assert!((other - paper_point()).max_abs() > 0.1);
    assert!(other.p.0.x.im.abs() > 0.1);
}

/// Negative control: the matrix A with one sign turned has neither property.
#[test]
fn another_matrix_is_not_an_isometry() {
    let z = paper_point();
    let (q, p) = real(&z);
    let mut wrong = matrix_a(&p);
    wrong[(0, 1)] = -wrong[(0, 1)];
    assert!((wrong * q - SpinorRealisation.apply(&z).0.0).norm() > 0.1);
    let square = wrong * wrong.transpose();
    assert!((square - Matrix3::from_diagonal_element(0.25 * p.norm_squared())).norm() > 0.01);
    let _: SourcePoint<SpinorRealisation> = z;
}
