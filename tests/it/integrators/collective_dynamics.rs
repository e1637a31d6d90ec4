//! Theorem 4.1(ii): φ_t∘M = M∘Φ_t, against exact values and between the two formulations.

use collective_integrators::{
    Collective, Direct, HamiltonianField, Integrator, RungeKutta, from_fn,
};
use heavytop::{HeavyTop, HeavyTopSpace, SpinorPoint, SpinorRealisation};
use lie_poisson::{Covector, LiePoisson, Pair, Se3, Se3Dual, Vector};
use momentum_map::{FibreSymmetry, Lift, PoissonMap};
use nalgebra::Vector3;
use std::error::Error;
use workspace_tests::{advance, assert_near, tops};

type Outcome = Result<(), Box<dyn Error>>;

fn direct(
    stages: usize,
    top: HeavyTop,
) -> Result<Direct<RungeKutta, HamiltonianField<HeavyTopSpace, HeavyTop>>, Box<dyn Error>> {
    let space = LiePoisson::minus(Se3::default());
    let field = HamiltonianField { space, hamiltonian: top };
    Ok(Direct::new(RungeKutta::gauss(stages)?, field))
}

fn collective(
    stages: usize,
    top: HeavyTop,
) -> Result<Collective<RungeKutta, SpinorRealisation, HeavyTop>, Box<dyn Error>> {
    Ok(Collective::new(RungeKutta::gauss(stages)?, SpinorRealisation, top))
}

/// The error after t = 1. At order 12 and steps of 1/50 the truncation error is far below round-off, of which 50
/// steps accumulate a few units of 4e-16 each.
const AFTER_ONE: f64 = 2e-14;

#[test]
fn the_exact_solution_after_one_time_unit() -> Outcome {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let end = tops::paper_exact();
    assert_near(&advance(&collective(6, top)?, &start, 0.02, 50)?, &end, AFTER_ONE);
    assert_near(&advance(&direct(6, top)?, &start, 0.02, 50)?, &end, AFTER_ONE);
    // Negative control: the implicit midpoint rule is nowhere near with the same steps.
    let midpoint = advance(&collective(1, top)?, &start, 0.02, 50)?;
    assert!((midpoint - end).max_abs() > 1e-4);
    Ok(())
}

/// φ_t∘M = M∘Φ_t for a top without symmetry and over a longer time.
#[test]
fn a_generic_top_in_both_formulations() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    let both = (
        advance(&collective(8, top)?, &start, 0.05, 200)?,
        advance(&direct(8, top)?, &start, 0.05, 200)?,
    );
    // The flow of ten time units stretches round-off by a factor of about 100.
    assert_near(&both.0, &both.1, 2e-13);
    assert!((both.0 - start).max_abs() > 0.1, "it moved");
    Ok(())
}

/// M∘Φ_t does not depend on the lift: four points of the fibre, far apart, have one image.
#[test]
fn every_lift_gives_the_same_motion() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    let gauss = collective(3, top)?;
    let end = advance(&gauss, &start, 0.05, 40)?;
    let z = SpinorRealisation.lift(&start)?;
    for (b, theta) in [(0.0, 2.0), (3.0, 0.0), (-1.0, 0.7)] {
        let z = SpinorRealisation.flow(1, theta, &SpinorRealisation.flow(0, b, &z));
        let last = gauss.trajectory_from(z, 0.05).take(41).last().ok_or("no sample")??;
        // equal up to round-off for a coarse method too: Runge–Kutta methods are equivariant
        assert_near(&last.momentum, &end, 1e-13);
    }
    Ok(())
}

/// The known solution of a free motion about the third axis is a rotation of the spinors: q̇ = ∂H/∂p and ṗ = −∂H/∂q,
/// in real coordinates.
#[test]
fn a_steady_rotation_is_a_rotation_of_the_spinors() -> Outcome {
    let top = HeavyTop::free_rigid_body(Vector3::new(1.0, 1.5, 2.0))?;
    let start = Se3Dual::new(Vector3::new(0.0, 0.0, 3.0), Vector3::new(0.6, 0.0, 0.8));
    let omega = 3.0 / 2.0;
    let z = SpinorRealisation.lift(&start)?;
    let last = collective(6, top)?.trajectory_from(z, 0.05).take(41).last().ok_or("none")??;
    // (i/2)(Ω·σ) on both spinors: e^{iΩt/2} on the first components, the conjugate on the second
    let turn = num_complex::Complex::from_polar(1.0, omega * 2.0 / 2.0);
    let rotated = |v: &nalgebra::Vector2<_>| nalgebra::Vector2::new(v.x * turn, v.y * turn.conj());
    let expected = SpinorPoint { q: rotated(&z.q), p: Covector(rotated(&z.p.0)) };
    assert_near(&last.state, &expected, 1e-14);
    // Γ turns backwards in the body frame
    let angle = omega * 2.0;
    let gamma = Vector3::new(0.6 * angle.cos(), -0.6 * angle.sin(), 0.8);
    assert_near(&last.momentum, &Se3Dual::new(Vector3::new(0.0, 0.0, 3.0), gamma), 1e-14);
    Ok(())
}

/// The equations (1.1), written here and integrated as a closure, give the same motion.
#[test]
fn the_equations_by_hand_follow_the_collective_motion() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    let by_hand = |sign: f64| {
        from_fn(move |&Covector(Pair(pi, gamma)): &Se3Dual| {
            let omega = pi.component_div(&Vector3::new(1.0, 1.4, 2.1));
            let c = Vector3::new(2.0, -3.0, 6.0) / 7.0;
            let moment = 0.7 * 9.81 * 0.2;
            Se3Dual::new(pi.cross(&omega) + gamma.cross(&c) * (sign * moment), gamma.cross(&omega))
        })
    };
    let run =
        |sign: f64| advance(&Direct::new(RungeKutta::gauss(8)?, by_hand(sign)), &start, 0.05, 40);
    let end = advance(&collective(8, top)?, &start, 0.05, 40)?;
    assert_near(&run(1.0)?, &end, 1e-13);
    // Negative control: gravity upside down.
    assert!((run(-1.0)? - end).max_abs() > 0.1);
    assert_near(&SpinorRealisation.apply(&SpinorRealisation.lift(&end)?), &end, 1e-14);
    Ok(())
}
