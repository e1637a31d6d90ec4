//! Typed errors, and states that stay as they were.

use crate::examples::{Quadratic, generic};
use isospectral_flows::collective_integrators::{
    Direct, Integrator, RungeKutta, SchemeError, StepError,
};
use isospectral_flows::lie_poisson::State;
use isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, IsospectralRungeKutta, LargeSkewHermitian,
};

#[test]
fn states_of_another_size_are_refused() {
    let expected = StepError::Dimension { expected: 16, found: 25 };
    let mut w = generic(5, 0.0);
    let magnus = GaussMagnus::new(2, Quadratic(4)).unwrap();
    assert_eq!(magnus.step_in_place(&mut w, 0.1, &mut magnus.workspace()), Err(expected));
    let midpoint = ExponentialMidpoint::new(Quadratic(4));
    assert_eq!(midpoint.step_in_place(&mut w, 0.1, &mut midpoint.workspace()), Err(expected));
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2).unwrap(), Quadratic(4));
    assert_eq!(gauss.step_in_place(&mut w, 0.1, &mut gauss.workspace()), Err(expected));
    let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(Quadratic(4)));
    let step = direct.step_in_place(&mut w, 0.1, &mut direct.workspace());
    assert_eq!(step, Err(StepError::NotFinite));
    assert_eq!(w, generic(5, 0.0));
}

#[test]
fn steps_that_do_not_converge_are_errors() {
    let mut w = generic(4, 0.5);
    let magnus = GaussMagnus::new(2, Quadratic(4)).unwrap();
    for h in [50.0, 1e5, 1e200] {
        let step = magnus.step_in_place(&mut w, h, &mut magnus.workspace());
        assert!(matches!(step, Err(StepError::NotConverged { .. })), "{h} {step:?}");
        let midpoint = ExponentialMidpoint::new(Quadratic(4));
        let step = midpoint.step_in_place(&mut w, h, &mut midpoint.workspace());
        let counted = |iterations: &usize| (1..=100).contains(iterations);
        assert!(
            matches!(&step, Err(StepError::NotConverged { iterations, .. }) if counted(iterations)),
            "{h} {step:?}"
        );
        assert_eq!(w, generic(4, 0.5));
    }
    // B is linear in W: a large W in a short step fails as a small one in a long step does.
    let midpoint = ExponentialMidpoint::new(Quadratic(4));
    let failure = |unit: f64| {
        let mut w = generic(4, 0.5);
        w.scale_in_place(unit);
        midpoint.step_in_place(&mut w, 50.0 / unit, &mut midpoint.workspace()).err()
    };
    assert!(failure(1.0).is_some());
    for unit in [0.25, 1024.0, 2.0_f64.powi(100)] {
        assert_eq!(failure(unit), failure(1.0), "{unit}");
    }
    // With a tolerance, the error compares the last change with it. Where the sweeps stay finite they may end like that.
    let loose = ExponentialMidpoint::new(Quadratic(4)).with_tolerance(1e-6);
    let unsolved = [2.0, 3.0, 4.0, 6.0, 9.0, 14.0, 20.0].into_iter().filter(|h| {
        let step = loose.step_in_place(&mut generic(4, 0.5), *h, &mut loose.workspace());
        match step {
            Err(StepError::NotConverged { residual, required, .. }) => {
                required == 1e-6 && residual > required
            }
            _ => false,
        }
    });
    assert!(unsolved.count() > 0);
    let mut w = generic(4, 0.5);
    w.set_coordinate(3, f64::NAN);
    assert!(magnus.step_in_place(&mut w, 0.1, &mut magnus.workspace()).is_err());
}

#[test]
fn numbers_of_stages_without_an_expansion_are_refused() {
    for stages in [0, 4, usize::MAX] {
        let refused = GaussMagnus::new(stages, Quadratic(4)).err();
        assert!(matches!(refused, Some(SchemeError::Family { stages: n, .. }) if n == stages));
    }
}

/// Steps of size zero, of W = 0 and of matrices with at most one entry change nothing.
#[test]
fn steps_without_motion() {
    fn assert_still<I: Integrator<State = LargeSkewHermitian>>(
        integrator: &I,
        start: &LargeSkewHermitian,
        h: f64,
    ) {
        let (mut w, mut workspace) = (start.clone(), integrator.workspace());
        for _ in 0..3 {
            integrator.step_in_place(&mut w, h, &mut workspace).unwrap();
        }
        assert_eq!(&w, start);
    }
    for (size, scale, h) in [(4, 1.0, 0.0), (4, 0.0, 0.3), (0, 1.0, 0.3), (1, 1.0, 0.3)] {
        let mut start = generic(size, 0.4);
        start.scale_in_place(scale);
        for stages in [1, 2, 3] {
            assert_still(&GaussMagnus::new(stages, Quadratic(size)).unwrap(), &start, h);
        }
        assert_still(&ExponentialMidpoint::new(Quadratic(size)), &start, h);
        let gauss = RungeKutta::gauss(2).unwrap();
        assert_still(&IsospectralRungeKutta::new(gauss, Quadratic(size)), &start, h);
    }
}
