//! The free rigid body: Jacobi's closed form against collective Gauss methods on C² and on T*C².

use collective_integrators::{Collective, RungeKutta, Start};
use heavytop::{HeavyTop, RigidBody, SpinorRealisation, jacobi_elliptic};
use lie_poisson::{
    Covector, DualNumber, PoissonSpace, Se3Dual, derivative_part, differential, map_coordinates,
};
use momentum_map::{FibreSymmetry, HOPF, PoissonMap};
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;
use proptest::prelude::*;
use std::error::Error;
use workspace_tests::{assert_close, assert_near, persistent, point};

type HopfPoint<T = f64> = Vector2<Complex<T>>;
type Outcome = Result<(), Box<dyn Error>>;

/// The round-off of 200 steps. Gauss with 6 stages and steps of 1/20 has a truncation error below round-off; the
/// steps accumulate some √200 · 2e-16, and t up to 10 in the elliptic functions costs a factor 10.
const ROUND_OFF: f64 = 1e-13;

/// Returns Π(t) = (A cn, 2A sn, C dn)(Ct/3 | m = 3A²/C²) for I = (1, 2, 3), with A = cos α, C = sin α.
fn closed_form(alpha: f64, t: f64) -> Vector3<f64> {
    let (a, c) = (alpha.cos(), alpha.sin());
    let [sn, cn, dn, _] = jacobi_elliptic(c * t / 3.0, 3.0 * a * a / (c * c));
    Vector3::new(a * cn, 2.0 * a * sn, c * dn)
}

const INERTIA: Vector3<f64> = Vector3::new(1.0, 2.0, 3.0);

/// The angles α, above 60° so that 3A² < C²: rotation about the third axis, near to it, and near the separatrix.
const ANGLES: [f64; 4] = [1.55, 1.4, 1.2, 1.0473];

#[test]
fn the_closed_form_on_c2() -> Outcome {
    let body = RigidBody::new(INERTIA)?;
    let gauss = Collective::new(RungeKutta::gauss(6)?, HOPF, body);
    for alpha in ANGLES {
        let start = Covector(closed_form(alpha, 0.0));
        for sample in gauss.trajectory(&start, 0.05)?.take(201) {
            let sample = sample?;
            assert_near(&sample.momentum.0, &closed_form(alpha, sample.time), ROUND_OFF);
        }
    }
    Ok(())
}

#[test]
fn the_closed_form_on_the_cotangent_bundle_of_c2() -> Outcome {
    let body = HeavyTop::free_rigid_body(INERTIA)?;
    let gauss = Collective::new(RungeKutta::gauss(6)?, SpinorRealisation, body);
    for alpha in ANGLES {
        let start = Se3Dual::new(closed_form(alpha, 0.0), Vector3::new(0.0, 0.6, -0.8));
        for sample in gauss.trajectory(&start, 0.05)?.take(201) {
            let sample = sample?;
            assert_near(&sample.momentum.0.0, &closed_form(alpha, sample.time), ROUND_OFF);
        }
    }
    Ok(())
}

/// The motion on the separatrix is Π = (½ sech, tanh, ½√3 sech)(t√3/6), on C² and on T∗C².
#[test]
fn the_separatrix() -> Outcome {
    let root = 3.0_f64.sqrt();
    let exact = |t: f64| {
        let u = t * root / 6.0;
        Vector3::new(0.5 / u.cosh(), u.tanh(), 0.5 * root / u.cosh())
    };
    let steps = RungeKutta::gauss(6)?;
    let on_c2 = Collective::new(steps.clone(), HOPF, RigidBody::new(INERTIA)?);
    let on_t_c2 = Collective::new(steps, SpinorRealisation, HeavyTop::free_rigid_body(INERTIA)?);
    let (pi, gamma) = (exact(0.0), Vector3::new(0.0, 0.6, -0.8));
    let small = on_c2.trajectory(&Covector(pi), 0.05)?;
    let large = on_t_c2.trajectory(&Se3Dual::new(pi, gamma), 0.05)?;
    for (small, large) in small.zip(large).take(201) {
        let (small, large) = (small?, large?);
        // Distances from the separatrix grow by e^{10√3/6} = 18 at most.
        assert_near(&small.momentum.0, &exact(small.time), 10.0 * ROUND_OFF);
        assert_near(&large.momentum.0.0, &exact(large.time), 10.0 * ROUND_OFF);
    }
    Ok(())
}

/// The closed form solves Π̇ = Π × I⁻¹Π, by central differences. Negative control: with the modulus
/// of another start it does not.
#[test]
fn the_closed_form_solves_the_equations() {
    let defect = |form: &dyn Fn(f64) -> Vector3<f64>| {
        let (t, step) = (1.3, 1e-4);
        let rate = (form(t + step) - form(t - step)) / (2.0 * step);
        (rate - form(t).cross(&form(t).component_div(&INERTIA))).norm()
    };
    for alpha in ANGLES {
        // The truncation error is step²/6, and round-off 1e-16/step.
        assert!(defect(&|t| closed_form(alpha, t)) < 1e-8);
    }
    let other = |t: f64| {
        let [sn, cn, dn, _] = jacobi_elliptic(t / 3.0, 0.5);
        Vector3::new(0.5 * cn, sn, dn)
    };
    assert!(defect(&other) > 1e-2);
}

/// The midpoint rule on C² conserves |Π|² and misses the phase: the comparison can fail.
#[test]
fn a_coarse_method_misses_the_closed_form() -> Outcome {
    let midpoint = Collective::new(RungeKutta::implicit_midpoint(), HOPF, RigidBody::new(INERTIA)?);
    let start = Covector(closed_form(1.2, 0.0));
    let mut largest = 0.0_f64;
    for sample in midpoint.trajectory(&start, 0.05)?.take(201) {
        let sample = sample?;
        assert_close(sample.momentum.0.norm(), 1.0, 1e-14);
        largest = largest.max((sample.momentum.0 - closed_form(1.2, sample.time)).norm());
    }
    assert!(largest > 1e-6);
    Ok(())
}

proptest! {
    #![proptest_config(persistent())]

    /// The fibres of the Hopf realisation are circles, generated by −½‖z‖², with |Π| = ¼‖z‖².
    #[test]
    fn the_fibres_of_the_hopf_realisation(z in point::<HopfPoint>(), s in -4.0..4.0_f64) {
        let moved = HOPF.flow(0, s, &z);
        assert_near(&HOPF.apply(&moved), &HOPF.apply(&z), 2e-15);
        prop_assert_eq!(HOPF.flow(1, s, &z), z);
        prop_assert_eq!(HOPF.momentum(1, &z), 0.0);

        let dj = differential(|z| HOPF.momentum::<DualNumber>(0, z), &z);
        let field = HOPF.source().hamiltonian_vector::<f64>(&z, &dj);
        let constant: HopfPoint<DualNumber> = map_coordinates(&z, DualNumber::constant);
        let flow = HOPF.flow(0, DualNumber::variable(0.0), &constant);
        let velocity: HopfPoint = derivative_part(&flow);
        assert_near(&field, &velocity, 1e-15);
        let size = HOPF.apply(&z).0.norm();
        assert_close(size, -0.5 * HOPF.momentum(0, &z), 1e-15);
    }
}

/// Negative control: a rotation of q alone moves the image.
#[test]
fn other_flows_leave_the_fibre() {
    let z = HopfPoint::new(Complex::new(0.3, 0.8), Complex::new(-1.0, 0.5));
    let moved = HopfPoint::new(Complex::new(1.0, 0.8), Complex::new(0.3, 0.5));
    assert!((HOPF.apply(&moved) - HOPF.apply(&z)).0.norm() > 0.1);
}
