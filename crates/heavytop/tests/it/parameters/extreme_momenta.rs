//! Lifts and attitudes of momenta of every size, from the smallest number to the largest.

use collective_integrators::{Collective, RungeKutta, Start};
use heavytop::{HeavyTop, SpinorRealisation, WithAttitude, attitude_of_vertical};
use lie_poisson::{Se3Dual, State, Vector};
use momentum_map::{Lift, PoissonMap};
use nalgebra::{Vector2, Vector3};

const LEAST: f64 = 5e-324;

/// Sizes at which squares underflow and overflow, down to the smallest number.
const SIZES: [f64; 9] = [LEAST, 1e-310, 1e-200, 1e-160, 1.0, 1e100, 1e160, 1e200, 5e307];

/// Returns whether two vectors agree to a dozen rounding errors, each at least half of the smallest number.
fn near(a: &Vector3<f64>, b: &Vector3<f64>) -> bool {
    (a - b).amax() <= 1e-14 * b.amax() + 8.0 * LEAST
}

fn directions() -> [Vector3<f64>; 6] {
    let v = Vector3::new;
    let axis = Vector3::z();
    [axis, -axis, v(1.0, 1.0, 1.0), v(-0.4, 1.0, -0.7), v(1e-9, -1e-12, -1.0), v(0.0, 1e-20, 1.0)]
}

/// M(lift(μ)) = μ for Π and Γ of sizes far apart, as long as ‖χ‖ = 2|Π|/√|Γ| is a number.
#[test]
fn spinors_lift_every_size() {
    let mut lifted = 0;
    for (size, other) in SIZES.iter().flat_map(|size| SIZES.map(|other| (*size, other))) {
        let length = size / other.sqrt();
        if !(1e-300..1e300).contains(&length) {
            continue;
        }
        for (pi, gamma) in directions().iter().flat_map(|a| directions().map(|b| (*a, b))) {
            let mu = Se3Dual::new(pi * size, gamma * other);
            let z = SpinorRealisation.lift(&mu).unwrap_or_else(|e| panic!("{mu:?}: {e}"));
            let image = SpinorRealisation.apply(&z);
            assert!(near(&image.0.0, &mu.0.0) && near(&image.0.1, &mu.0.1), "{mu:?}: {image:?}");
            lifted += 1;
        }
    }
    assert!(lifted > 1500, "{lifted}");
}

#[test]
fn reasons_name_what_is_wrong() {
    let reason = |pi, gamma| match SpinorRealisation.lift::<f64>(&Se3Dual::new(pi, gamma)) {
        Ok(z) => format!("{z:?}"),
        Err(error) => error.to_string(),
    };
    let (one, zero) = (Vector3::new(1.0, 2.0, 3.0), Vector3::zeros());
    let huge = Vector3::new(1.0, 1.0, 1.0) * 1e308;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let bad = Vector3::new(1e-300, bad, 0.0);
        for text in [reason(bad, one), reason(one, bad)] {
            assert!(text.contains("Π and Γ must be finite"), "{text}");
        }
    }
    assert!(reason(one, zero).contains("Γ must be different from 0"));
    assert!(reason(huge, one).contains("below 1.7e308"), "{}", reason(huge, one));
    assert!(reason(one * 1e200, one * 1e-300).contains("2|Π|/√|Γ|"));
    // Momenta within the bounds have a lift.
    let mu =
        Se3Dual::new(Vector3::new(1.0, 1.0, 1.0) * 4.9e307, Vector3::new(1.0, 1.0, 1.0) * 9.8e307);
    assert!(SpinorRealisation.lift(&mu).is_ok(), "{:?}", SpinorRealisation.lift(&mu));
    assert!(SpinorRealisation.lift(&Se3Dual::new(one, Vector3::x() * LEAST)).is_ok());
}

/// Next to −e₃ the lift with a given Re χ₁ is so long that Π would be lost in its rounding errors.
#[test]
fn a_given_re_chi1_next_to_the_lower_pole() {
    let mu = |x| Se3Dual::new(Vector3::new(1.0, 2.0, 3.0), Vector3::new(x, 0.0, -1.0));
    for x in [0.0, 1e-300, 1e-180, 1e-20, 1e-9] {
        let error = SpinorRealisation.lift_with(&mu(x), 1.0).unwrap_err();
        assert!(error.reason.contains("must not point along −e₃"), "{error}");
        assert!(error.value <= 1e-8 && (error.value - x / 2.0).abs() <= 1e-12 * x, "{error}");
    }
    for x in [1e-7, 1e-3] {
        let z = SpinorRealisation.lift_with(&mu(x), 1.0).unwrap();
        let error = (SpinorRealisation.apply(&z) - mu(x)).max_abs();
        assert!(error < 1e-14 / x, "{x}: {error:e}");
    }
    let text = SpinorRealisation.lift_with(&mu(0.5), 1e308).unwrap_err().to_string();
    assert!(text.contains("Re χ₁ must be so small"), "{text}");
    // Below the equator ψ₁ of the minimal lift is not real.
    let mu = Se3Dual::new(Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.4, -0.5, -0.6));
    assert!(SpinorRealisation.lift(&mu).unwrap().p.0.x.im.abs() > 0.1);
    let z = SpinorRealisation.lift_with(&mu, 1.0).unwrap();
    assert!(z.p.0.x.re > 0.0 && z.p.0.x.im.abs() < 1e-16, "{z:?}");
    assert!((SpinorRealisation.apply(&z) - mu).max_abs() < 1e-14);
}

#[test]
fn verticals_of_every_size_have_an_attitude() {
    for size in SIZES {
        for direction in directions() {
            let gamma = direction * size;
            let attitude = attitude_of_vertical(&gamma);
            let unit = gamma / gamma.amax();
            let seen = attitude.conjugate().rotate(&Vector3::z());
            assert!((seen - unit.normalize()).norm() < 2e-15, "{gamma:?}: {seen}");
            assert!((attitude.norm_squared() - 1.0).abs() < 1e-15, "{gamma:?}");
        }
    }
    // The shortest rotation for a Γ that differs from −e₃ by numbers whose squares underflow.
    let turn = attitude_of_vertical(&Vector3::new(LEAST, 0.0, -1.0));
    assert_eq!((turn.vector.xy(), turn.vector.z), (Vector2::new(0.0, -1.0), 0.0));
    let run = WithAttitude(Collective::new(
        RungeKutta::implicit_midpoint(),
        SpinorRealisation,
        HeavyTop::kovalevskaya(1.0, 1.0).unwrap(),
    ));
    let start = Se3Dual::new(Vector3::x() * 1e-170, Vector3::new(0.6, 0.0, 0.8) * 1e-170);
    assert!(run.start(&start).is_ok_and(|state| state.1.is_finite()));
}
