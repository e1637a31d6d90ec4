//! Trajectories: where they start, where they end, and that no failure is lost.

use collective_integrators::{
    Direct, IntegrationError, Integrator, RunError, RungeKutta, Sample, Start, Step, StepError,
    VectorField, from_fn,
};
use nalgebra::{Vector1, Vector2};
use std::cell::Cell;

/// Returns the vector field ẋ = x², whose solution from 1 is infinite at t = 1.
fn blow_up() -> Direct<RungeKutta, impl VectorField<Point = Vector1<f64>>> {
    let field = from_fn(|x: &Vector1<f64>| Vector1::new(x[0] * x[0]));
    Direct::new(RungeKutta::implicit_midpoint(), field)
}

#[test]
fn a_failure_is_not_lost_by_skipping() {
    let integrator = blow_up();
    let run = || integrator.trajectory_from(Vector1::x(), 0.1);
    let samples: Vec<_> = run().take(100).collect();
    let failed = samples.iter().position(Result::is_err).unwrap_or(0);
    assert!((2..99).contains(&failed), "{failed}");
    let error = samples[failed].err();
    assert!(error.is_some_and(|error| error.step == failed as u64));
    assert!(samples[failed..].iter().all(|sample| sample.err() == error));
    for skipped in [0, 1, 2, 1000] {
        assert_eq!(run().nth(failed + skipped).map(|sample| sample.err()), Some(error));
    }
    assert!(run().step_by(failed - 1).nth(2).is_some_and(|sample| sample.err() == error));
    let collected: Result<Vec<_>, _> = run().collect();
    assert_eq!(collected.err(), error);
    assert_eq!(run().map_while(Result::ok).count(), failed);
}

/// The implicit Euler method for ẋ = −x, which counts the momenta that are read.
#[derive(Default)]
struct Counting(Cell<usize>);

impl Integrator for Counting {
    type State = Vector1<f64>;
    type Momentum = Vector1<f64>;
    type Workspace = ();

    fn workspace(&self) {}

    fn step(&self, x: &Vector1<f64>, h: f64, (): &mut ()) -> Result<Step<Self::State>, StepError> {
        Step { point: x / (1.0 + h), iterations: 0 }.finite()
    }

    fn forget(&self, (): &mut ()) {}

    fn momentum(&self, x: &Vector1<f64>) -> Vector1<f64> {
        self.0.set(self.0.get() + 1);
        *x
    }
}

#[test]
fn samples_that_are_skipped_are_not_made_and_the_others_are_the_same() {
    let all: Vec<_> = Counting::default().trajectory_from(Vector1::x(), 0.1).take(31).collect();
    let counting = Counting::default();
    let run = || counting.trajectory_from(Vector1::x(), 0.1);
    let tenth: Vec<_> = run().step_by(10).take(4).collect();
    assert_eq!(tenth, [0, 10, 20, 30].map(|n| all[n]));
    assert_eq!(counting.0.take(), 4);
    assert_eq!(run().skip(7).nth(5), Some(all[12]));
    assert_eq!(counting.0.take(), 1);
    // Control: a sample that is asked for is counted.
    assert_eq!((run().take(5).count(), counting.0.take()), (5, 5));
}

#[test]
fn one_sample_after_many_steps() {
    let integrator = blow_up();
    let run: Vec<_> = integrator.trajectory_from(Vector1::x(), 0.05).take(40).collect();
    let mut iterations = 0;
    for (n, sample) in (0..).zip(run) {
        let alone = integrator.after(&Vector1::x(), 0.05, n);
        // A sample counts the iterations of all steps since the one before it.
        let expected = sample.map(|sample| {
            iterations += sample.iterations;
            Sample { iterations, ..sample }
        });
        assert_eq!(alone, expected.map_err(RunError::Integration));
    }
}

#[test]
fn a_start_that_is_not_finite_is_refused() {
    let rk4 = Direct::new(RungeKutta::rk4(), from_fn(|z: &Vector2<f64>| -*z));
    let start = Vector2::new(1.0, 2.0);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let nowhere = Vector2::new(1.0, bad);
        let of_start = |e: StepError| matches!(e, StepError::NotFiniteStart { coordinate: 1, size } if !size.is_finite());
        let of_step = |e: StepError| matches!(e, StepError::StepSize { step } if !step.is_finite());
        let cases: [(_, _, &dyn Fn(StepError) -> bool); 2] =
            [(nowhere, 0.5, &of_start), (start, bad, &of_step)];
        for (state, step, named) in cases {
            let fits = |e: IntegrationError, made: u64| e.step == made + 1 && named(e.source);
            let at_start = |e| matches!(e, RunError::Integration(e) if fits(e, 0) && e.time == 0.0);
            assert!(rk4.trajectory(&state, step).is_err_and(at_start));
            assert!(rk4.after(&state, step, 0).is_err_and(at_start));
            let first = rk4.trajectory_from(state, step).next().and_then(Result::err);
            assert!(first.is_some_and(|e| fits(e, 0) && e.time == 0.0));
            let resumed = rk4.trajectory_resumed(state, 7, step).nth(3).and_then(Result::err);
            assert!(resumed.is_some_and(|e| fits(e, 7)));
        }
    }
    assert!(rk4.after(&start, 0.5, 0).is_ok_and(|sample| sample.state == start));
}

#[test]
fn the_last_number_of_a_step_is_followed_by_none() {
    let rk4 = Direct::new(RungeKutta::rk4(), from_fn(|z: &Vector2<f64>| -*z));
    let mut run = rk4.trajectory_resumed(Vector2::x(), u64::MAX - 1, 1e-9);
    let numbers = [run.next(), run.next()].map(|s| s.and_then(Result::ok).map(|s| s.step));
    assert_eq!(numbers, [Some(u64::MAX - 1), Some(u64::MAX)]);
    let end = run.next().and_then(Result::err);
    assert!(end.is_some_and(|e| (e.step, e.source) == (u64::MAX, StepError::Uncountable)));
    assert!(run.next().is_some_and(|sample| sample.err() == end));
    // So it is where the last one is skipped.
    for skipped in [3, 4, 100] {
        let mut run = rk4.trajectory_resumed(Vector2::x(), u64::MAX - 3, 1e-9);
        let last = run.nth(skipped).and_then(|sample| sample.map(|s| s.step).ok());
        assert_eq!(last, (skipped == 3).then_some(u64::MAX), "{skipped}");
    }
    let mut run = rk4.trajectory_resumed(Vector2::x(), u64::MAX, 1e-9);
    assert!(run.next().is_some_and(|s| s.is_ok()) && run.next().is_some_and(|s| s.is_err()));
}
