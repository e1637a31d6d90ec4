//! Steps that are far too large: they converge through Newton's iteration, or fail with an error that says so. They
//! never return a wrong state.

use collective_integrators::{
    Collective, Direct, HamiltonianField, LiftFree, RungeKutta, StageSolver, Start, StepError,
};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::{
    Covector, Hamiltonian, LiePoisson, Pair, Se3, Se3Dual, Vector, from_closure, from_closures,
};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use workspace_tests::tops;

fn top() -> HeavyTop {
    tops::paper().unwrap()
}

fn casimirs(mu: &Se3Dual) -> [f64; 2] {
    [mu.0.1.dot(&mu.0.1), mu.0.0.dot(&mu.0.1)]
}

/// Makes one step, and returns it with the iterations of the solver.
fn step<I: Start<f64, Momentum = Se3Dual>>(
    integrator: &I,
    h: f64,
) -> Result<(Se3Dual, usize), StepError> {
    let state = integrator.start(&tops::paper_start()).unwrap();
    let step = integrator.step(&state, h, &mut integrator.workspace())?;
    Ok((integrator.momentum(&step.point), step.iterations))
}

#[test]
fn large_steps_keep_what_the_method_promises_or_fail() {
    let [f1, f2] = casimirs(&tops::paper_start());
    let mut solved = 0;
    for scheme in [
        RungeKutta::implicit_midpoint(),
        RungeKutta::gauss(2).unwrap(),
        RungeKutta::gauss(4).unwrap(),
    ] {
        for h in [0.2, 0.5, 1.0, 2.0, 10.0, 1e3, 1e6, 1e12, 1e30, 1e150, 1e300] {
            let lifted = step(&Collective::new(scheme.clone(), SpinorRealisation, top()), h);
            let free = step(&LiftFree::new(scheme.clone(), DualQuaternions, top()), h);
            // The lift-free form conserves the Casimirs whatever its stages are: they must be right too. Beyond a
            // turn or two the equations have several solutions.
            if h <= 1.0 {
                let ((a, _), (b, _)) = (lifted.unwrap(), free.unwrap());
                assert!((a - b).max_abs() < 1e-12, "{h}: {:e}", (a - b).max_abs());
            }
            for outcome in [lifted, free] {
                match outcome {
                    Ok((mu, _)) => {
                        solved += 1;
                        let [g1, g2] = casimirs(&mu);
                        // The bound is a few rounding errors of f₂ = 4.5, whatever the step.
                        assert!((g1 - f1).abs() < 2e-14, "{h}: {g1}");
                        assert!((g2 - f2).abs() < 2e-14, "{h}: {g2}");
                    }
                    Err(StepError::NotConverged { residual, required, .. }) => {
                        assert!(residual.is_nan() || residual >= required, "{residual} {required}");
                    }
                    // The iteration went further than half the size of the stages.
                    Err(StepError::OtherSolution { distance }) => assert!(distance > 0.5),
                    Err(StepError::NotFinite) => {}
                    Err(error) => panic!("{error}"),
                }
            }
        }
    }
    assert_eq!(solved, 36, "those up to 10³, of 66");
}

#[test]
fn newton_and_the_fixed_point_find_the_same_step() {
    let fixed = StageSolver { newton: false, max_iterations: 1000, ..StageSolver::default() };
    let newton = StageSolver { max_iterations: 1, ..StageSolver::default() };
    for s in [1, 2, 3] {
        let run = |solver| {
            let scheme = RungeKutta::gauss(s).unwrap().with_solver(solver);
            step(&Collective::new(scheme, SpinorRealisation, top()), 0.1).unwrap()
        };
        let ((a, sweeps), (b, iterations)) = (run(fixed), run(newton));
        assert!((a - b).max_abs() < 1e-14, "{:e}", (a - b).max_abs());
        // Newton's iteration doubles its digits: one sweep, and a handful of iterations.
        assert!(iterations <= 8 && iterations < sweeps, "{iterations} {sweeps}");
    }
}

#[test]
fn without_newton_a_large_step_is_an_error() {
    let fixed = StageSolver { newton: false, ..StageSolver::default() };
    let scheme = RungeKutta::implicit_midpoint().with_solver(fixed);
    let outcome = step(&Collective::new(scheme, SpinorRealisation, top()), 1.0);
    assert!(matches!(outcome, Err(StepError::NotConverged { .. })), "{outcome:?}");
}

#[test]
fn a_hamiltonian_without_second_derivative_is_solved_by_difference_quotients() {
    let by_hand = from_closures::<LiePoisson<Se3>, _, _>(
        |mu| top().value(mu),
        |mu| Hamiltonian::<LiePoisson<Se3>>::differential(&top(), mu),
    );
    let scheme = RungeKutta::gauss(2).unwrap();
    let known = step(&LiftFree::new(scheme.clone(), DualQuaternions, top()), 1.0).unwrap();
    let unknown = step(&LiftFree::new(scheme, DualQuaternions, by_hand), 1.0).unwrap();
    assert!((known.0 - unknown.0).max_abs() < 1e-13);
    assert!(unknown.1 >= known.1, "exact derivatives are not slower");
}

#[test]
fn a_field_that_is_not_a_number_is_an_error_at_every_method() {
    let broken = || from_closure::<LiePoisson<Se3>, _>(|Covector(Pair(pi, _))| pi.x * f64::NAN);
    let nan = |outcome: Result<(Se3Dual, usize), StepError>| {
        assert!(outcome.is_err(), "{outcome:?}");
    };
    for scheme in
        [RungeKutta::implicit_midpoint(), RungeKutta::rk4(), RungeKutta::gauss(3).unwrap()]
    {
        nan(step(&Collective::new(scheme.clone(), SpinorRealisation, broken()), 0.1));
        nan(step(&LiftFree::new(scheme.clone(), DualQuaternions, broken()), 0.1));
        nan(step(&LiftFree::new(scheme.clone(), DualQuaternions, broken()).compensated(), 0.1));
        let field =
            HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: broken() };
        nan(step(&Direct::new(scheme, field), 0.1));
    }
    let nowhere = Se3Dual::new(Vector3::new(f64::NAN, 0.0, 0.0), Vector3::z());
    let scheme = RungeKutta::implicit_midpoint();
    assert!(Collective::new(scheme, SpinorRealisation, top()).trajectory(&nowhere, 0.1).is_err());
}
