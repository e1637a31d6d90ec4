//! The lift-free integrator for copies of 𝔤∗, against that for a number which the compiler knows, and with a lift.

use crate::sites::collective_sites::{COUNT, Ring, spin, spins};
use crate::support::laws;
use collective_integrators::*;
use lie_poisson::*;
use momentum_map::{HOPF, PowerMultipliers, Quaternions};
use nalgebra::Vector3;

type Spins = Covector<Sites<Vector3<f64>>>;

fn lift_free(stages: usize) -> LiftFreeSites<RungeKutta, Quaternions, Ring> {
    LiftFreeSites::new(RungeKutta::gauss(stages).unwrap(), Quaternions, Ring)
}

/// Two thousand steps pass a checkpoint, at which both forget the steps before.
#[test]
fn a_number_at_run_time_changes_no_bit() {
    for (stages, steps) in [(1, 50), (2, 2000), (3, 50)] {
        let scheme = RungeKutta::gauss(stages).unwrap();
        let few = LiftFree::new(scheme, PowerMultipliers::<_, COUNT>(Quaternions), Ring);
        let mu = Covector(Power(core::array::from_fn(spin)));
        let a = few.trajectory(&mu, 0.1).unwrap().take(steps);
        let many = lift_free(stages);
        let b = many.trajectory(&spins(COUNT), 0.1).unwrap().take(steps);
        for (a, b) in a.zip(b) {
            let (a, b) = (a.unwrap(), b.unwrap());
            assert_eq!(a.iterations, b.iterations, "step {}", a.step);
            assert_eq!(a.momentum.0.0[..], b.momentum.0[..], "step {}", a.step);
        }
    }
}

#[test]
fn the_step_is_that_with_a_lift() {
    let start = spins(8);
    let lifted = CollectiveSites::new(RungeKutta::gauss(2).unwrap(), HOPF, Ring);
    let a = lifted.after(&start, 0.1, 100).unwrap().momentum;
    let b = lift_free(2).after(&start, 0.1, 100).unwrap().momentum;
    let apart = |a: &Spins, b: &Spins| {
        a.0.iter().zip(b.0.iter()).map(|(a, b)| (a - b).norm()).fold(0.0, larger)
    };
    // 100 steps, each with a few roundings of numbers of size 1.
    assert!(apart(&a, &b) < 1e-12, "{:e}", apart(&a, &b));
    // control: another method
    let other = lift_free(3).after(&start, 0.1, 100).unwrap().momentum;
    assert!(apart(&a, &other) > 1e-7);
}

#[test]
fn the_laws_of_integrators_hold() {
    let length = |s: &Spins| s.0[2].norm();
    let sum = |s: &Spins| s.0.iter().sum::<Vector3<f64>>().z;
    // Of fewer spins the steps have the same bits with and without the ones before.
    let (momenta, step) = ([spins(8), Covector((5..13).map(spin).collect())], 0.1);
    laws::start(&lift_free(2), &momenta, step).unwrap().check(1e-13).unwrap();
    let conserved = laws::invariants(&lift_free(2), &momenta, step, &[&length, &sum]);
    conserved.unwrap().check(1e-13).unwrap();
    // control: a scheme that is not symplectic; its multipliers are quaternions, too, which rotate each spin
    let rk4 = LiftFreeSites::new(RungeKutta::rk4(), Quaternions, Ring);
    let lost = laws::invariants(&rk4, &momenta, step, &[&sum]);
    assert!(lost.unwrap().check(1e-13).is_err());
}

#[test]
fn another_number_of_sites_begins_anew() {
    let (gauss, mut workspace) = (lift_free(2), Integrator::<f64>::workspace(&lift_free(2)));
    for count in [4, 2, 0, 7] {
        let (mut here, mut alone) = (spins(count), spins(count));
        for _ in 0..3 {
            gauss.step_in_place(&mut here, 0.1, &mut workspace).unwrap();
        }
        let mut own = Integrator::<f64>::workspace(&gauss);
        for _ in 0..3 {
            gauss.step_in_place(&mut alone, 0.1, &mut own).unwrap();
        }
        assert_eq!(here, alone);
    }
}

#[test]
fn a_state_that_is_not_finite_is_an_error_and_is_not_changed() {
    let gauss = lift_free(1);
    let mut s = spins(3);
    s.0[1].x = f64::NAN;
    let before = s.0[0];
    assert!(gauss.step_in_place(&mut s, 0.1, &mut gauss.workspace()).is_err());
    assert!(s.0[0] == before && s.0[1].x.is_nan());
    // the next run of the same storage is not spoilt
    let mut workspace = gauss.workspace();
    gauss.step_in_place(&mut s, 0.1, &mut workspace).unwrap_err();
    let mut good = spins(3);
    gauss.step_in_place(&mut good, 0.1, &mut workspace).unwrap();
    assert_eq!(good, gauss.step(&spins(3), 0.1, &mut gauss.workspace()).unwrap().point);
}

/// Tangent vectors on the heap know their dimension only when the program runs.
#[test]
fn tangent_vectors_of_another_dimension_are_refused() {
    let gauss = lift_free(1);
    for (count, expected) in [(4, true), (3, false), (5, false), (0, false)] {
        let mut flow = VariationalFlow::new(&gauss, spins(4), [spins(4), spins(count)], 0.1);
        let refused = StepError::Dimension { expected: 12, found: 3 * count };
        match flow.advance() {
            Ok(()) => assert!(expected, "{count} sites"),
            Err(VariationalError::Integration(error)) => {
                assert_eq!((expected, error.source), (false, refused));
                // nothing has changed
                assert_eq!((flow.steps(), flow.state()), (0, &spins(4)));
            }
            Err(error) => panic!("{error}"),
        }
    }
}
