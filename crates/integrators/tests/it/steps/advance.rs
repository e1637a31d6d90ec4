//! Many steps at once, in place and between the samples of a trajectory.

use collective_integrators::*;
use lie_poisson::{Covector, LiePoisson, So3, from_closure};
use momentum_map::HOPF;
use nalgebra::{Vector1, Vector2, Vector3};
use std::cell::Cell;
use std::num::NonZero;

/// Makes the steps of `advance` one by one.
fn loop_of_steps<I: Integrator>(
    integrator: &I,
    mut z: I::State,
    step: f64,
    steps: u64,
) -> I::State {
    let mut workspace = integrator.workspace();
    for made in 0..steps {
        if made.is_multiple_of(CHECKPOINT) {
            integrator.forget(&mut workspace);
        }
        integrator.step_in_place(&mut z, step, &mut workspace).unwrap();
    }
    z
}

/// Returns the state after steps in two parts, between which the workspace may be renewed.
fn in_parts<I: Integrator>(
    integrator: &I,
    mut z: I::State,
    step: f64,
    [middle, end]: [u64; 2],
    renewed: bool,
) -> I::State {
    let mut workspace = integrator.workspace();
    integrator.advance(&mut z, step, 0..middle, &mut workspace).unwrap();
    if renewed {
        workspace = integrator.workspace();
    }
    integrator.advance(&mut z, step, middle..end, &mut workspace).unwrap();
    z
}

/// Returns the number of iterations of all steps to the last of the samples.
fn iterations<S, M>(samples: &[Sample<S, M>]) -> usize {
    samples.iter().map(|sample| sample.iterations).sum()
}

/// Checks that many steps at once have the bits of the steps of a loop and of a trajectory, wherever they are divided: in
/// the middles, and between every so many.
fn keeps_the_bits<I: Integrator<State: PartialEq>>(
    integrator: &I,
    start: &I::State,
    middles: &[u64],
    intervals: &[usize],
) {
    const STEPS: u64 = CHECKPOINT + 50;
    let end = loop_of_steps(integrator, start.clone(), 0.1, STEPS);
    for &middle in middles {
        assert!(in_parts(integrator, start.clone(), 0.1, [middle, STEPS], false) == end);
    }
    assert!(in_parts(integrator, start.clone(), 0.1, [CHECKPOINT, STEPS], true) == end);
    // Control: one step less is another state.
    assert!(in_parts(integrator, start.clone(), 0.1, [700, STEPS - 1], false) != end);

    let run = || integrator.trajectory_from(start.clone(), 0.1);
    let all: Vec<_> = run().take(STEPS as usize + 1).map(Result::unwrap).collect();
    assert!(all.last().is_some_and(|sample| sample.state == end));
    for &middle in middles {
        let mut parts = run();
        assert!(*parts.advance(0).unwrap() == *start && *parts.state() == *start);
        assert!(*parts.advance(middle).unwrap() == all[middle as usize].state);
        assert!(*parts.advance(STEPS - 1 - middle).unwrap() != end);
        let last = parts.next().unwrap().unwrap();
        assert!(last.step == STEPS && last.state == end);
    }
    for &n in intervals {
        let expected = all.iter().step_by(n);
        let found = run().every(NonZero::new(n).unwrap()).map(Result::unwrap);
        let mut counted = 0;
        assert!(expected.clone().zip(found).all(|(a, b)| {
            counted += b.iterations;
            let all_counted = counted == iterations(&all[..=a.step as usize]);
            (a.step, a.time) == (b.step, b.time) && a.state == b.state && all_counted
        }));
        assert!(expected.len() > 1);
    }
}

/// A map that depends on the number of steps since the workspace forgot.
struct Remembering;

impl Integrator for Remembering {
    type State = Vector1<f64>;
    type Momentum = Vector1<f64>;
    type Workspace = f64;

    fn workspace(&self) -> f64 {
        0.0
    }

    fn step(
        &self,
        x: &Vector1<f64>,
        h: f64,
        made: &mut f64,
    ) -> Result<Step<Self::State>, StepError> {
        *made += 1.0;
        Step { point: x.map(|x| (x + h * *made).sin()), iterations: *made as usize }.finite()
    }

    fn forget(&self, made: &mut f64) {
        *made = 0.0;
    }

    fn momentum(&self, x: &Vector1<f64>) -> Vector1<f64> {
        *x
    }
}

#[test]
fn a_workspace_remembers_until_the_next_checkpoint() {
    let start = Vector1::zeros();
    let middles = [0, 700, CHECKPOINT, CHECKPOINT + 1];
    keeps_the_bits(&Remembering, &start, &middles, &[1, 100, CHECKPOINT as usize + 1]);
    // Control: with another workspace the steps before are forgotten, which only a checkpoint permits.
    let end =
        |middle, renewed| in_parts(&Remembering, start, 0.1, [middle, CHECKPOINT + 9], renewed);
    assert!(end(CHECKPOINT + 1, false) != end(CHECKPOINT + 1, true));
    assert!(end(CHECKPOINT, false) == end(CHECKPOINT, true));
}

#[test]
fn many_steps_at_once_have_the_bits_of_single_ones() {
    let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
    let direct = Direct::new(RungeKutta::gauss(2).unwrap(), pendulum);
    keeps_the_bits(&direct, &Vector2::x(), &[700, CHECKPOINT + 1], &[1, CHECKPOINT as usize + 1]);
    let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
    let collective = Collective::new(RungeKutta::gauss(2).unwrap(), HOPF, h);
    let mu = Covector(Vector3::new(0.6, 0.3, 0.8));
    keeps_the_bits(&collective, &collective.start(&mu).unwrap(), &[700], &[100]);
    // The rounding errors that are carried along are a part of the state.
    let compensated = collective.compensated();
    let start = compensated.start(&mu).unwrap();
    keeps_the_bits(&compensated, &start, &[700], &[100]);
    assert!(loop_of_steps(&compensated, start, 0.1, 100).1 != start.1);
}

#[test]
fn a_failure_leaves_the_state_before_the_failed_step() {
    // The solution of ẋ = x² from 1 is infinite at t = 1.
    let field = from_fn(|x: &Vector1<f64>| Vector1::new(x[0] * x[0]));
    let midpoint = Direct::new(RungeKutta::implicit_midpoint(), field);
    let run = || midpoint.trajectory_from(Vector1::x(), 0.1);
    let good: Vec<_> = run().map_while(Result::ok).collect();
    let failed = good.len() as u64;
    let error = run().nth(good.len()).and_then(Result::err).unwrap();
    assert!(failed > 2 && error.step == failed);
    let advanced = |steps| {
        let mut x = Vector1::x();
        (midpoint.advance(&mut x, 0.1, 0..steps, &mut midpoint.workspace()), x)
    };
    for steps in [failed, failed + 1, 10 * CHECKPOINT, u64::MAX] {
        assert_eq!(advanced(steps), (Err(error), good[good.len() - 1].state));
    }
    for n in [failed + 1, 10 * CHECKPOINT, usize::MAX as u64] {
        let mut items = run().every(NonZero::new(n as usize).unwrap());
        assert_eq!(items.next(), Some(Ok(good[0])));
        assert!((0..3).all(|_| items.next() == Some(Err(error))));
    }
    // Control: one step less has a result.
    let last = good[good.len() - 1];
    assert_eq!(advanced(failed - 1), (Ok(iterations(&good)), last.state));
}

#[test]
fn no_steps_change_nothing_but_a_start_that_is_not_finite_is_refused() {
    let rk4 = Direct::new(RungeKutta::rk4(), from_fn(|z: &Vector2<f64>| -*z));
    let advance = |mut z: Vector2<f64>, step, steps| {
        (rk4.advance(&mut z, step, steps, &mut rk4.workspace()), z)
    };
    let start = Vector2::new(1.0, 2.0);
    for made in [0, 5, CHECKPOINT, u64::MAX] {
        assert_eq!(advance(start, 0.1, made..made), (Ok(0), start));
        for (z, step) in [(Vector2::new(1.0, f64::NAN), 0.1), (start, f64::INFINITY)] {
            let refused = StepError::check_start(&z, step).unwrap_err();
            let (outcome, after) = advance(z, step, made..made);
            let error = outcome.unwrap_err();
            assert_eq!(error.step, made.saturating_add(1));
            assert_eq!(format!("{}", error.source), format!("{refused}"));
            assert!(after.x == z.x && (after.y == z.y || z.y.is_nan()));
        }
    }
    // Control: one step changes the state.
    assert!(advance(start, 0.1, 5..6).1 != start);
}

/// A map that counts its steps, of which single ones are forbidden.
struct AtOnce(Cell<u64>);

impl Integrator for AtOnce {
    type State = Vector1<f64>;
    type Momentum = Vector1<f64>;
    type Workspace = ();

    fn workspace(&self) {}

    fn step(&self, x: &Vector1<f64>, _: f64, (): &mut ()) -> Result<Step<Self::State>, StepError> {
        self.0.set(self.0.get() + 1);
        Ok(Step { point: *x, iterations: 0 })
    }

    fn advance(
        &self,
        x: &mut Vector1<f64>,
        _: f64,
        steps: std::ops::Range<u64>,
        (): &mut (),
    ) -> Result<usize, IntegrationError> {
        x.x += (steps.end - steps.start) as f64;
        Ok(7)
    }

    fn forget(&self, (): &mut ()) {}

    fn momentum(&self, x: &Vector1<f64>) -> Vector1<f64> {
        *x
    }
}

impl StateIsMomentum for AtOnce {}

#[test]
fn a_trajectory_makes_the_steps_between_samples_at_once() {
    let integrator = AtOnce(Cell::new(0));
    let hundredth = NonZero::new(100).unwrap();
    let samples = integrator.trajectory_from(Vector1::zeros(), 0.5).every(hundredth).take(4);
    let found =
        samples.map(|s| s.map(|s| (s.step, s.time, s.state.x))).collect::<Result<Vec<_>, _>>();
    // The first step after a sample and the last one before the next are single ones.
    let expected = [(0, 0.0, 0.0), (100, 50.0, 98.0), (200, 100.0, 196.0), (300, 150.0, 294.0)];
    assert_eq!(found, Ok(expected.to_vec()));
    assert_eq!(integrator.0.take(), 6);
    let end = integrator.after(&Vector1::zeros(), 0.5, u64::MAX).unwrap();
    assert_eq!((end.step, integrator.0.take()), (u64::MAX, 1));
}

#[test]
fn the_last_number_of_a_step_ends_every_stride() {
    let integrator = AtOnce(Cell::new(0));
    for n in [1, 2, 3, 5, 1 << 40, usize::MAX] {
        let run = || integrator.trajectory_resumed(Vector1::zeros(), u64::MAX - 4, 0.5);
        let numbers = |s: Option<Result<Sample<_, _>, IntegrationError>>| match s {
            Some(Ok(sample)) => Ok(sample.step),
            Some(Err(error)) => Err((error.step, error.source)),
            None => Ok(0),
        };
        let mut items = run().every(NonZero::new(n).unwrap());
        for i in 0..8_u64 {
            let expected = match i.saturating_mul(n as u64) {
                made @ 0..=4 => Ok(u64::MAX - 4 + made),
                _ => Err((u64::MAX, StepError::Uncountable)),
            };
            assert_eq!(numbers(items.next()), expected, "{n} {i}");
        }
    }
}

/// The field is not a number from 2.7 on, where stages of the sixth step lie.
#[test]
fn a_run_that_fails_keeps_the_state_before_the_step() {
    let field = from_fn(|x: &Vector1<f64>| x.map(|x| if x < 2.7 { 1.0 } else { f64::NAN }));
    let rk4 = Direct::new(RungeKutta::rk4(), field);
    let mut run = rk4.trajectory_from(Vector1::zeros(), 0.5);
    let fifth = rk4.after_from(Vector1::zeros(), 0.5, 5).unwrap().state;
    assert!(run.advance(4).is_ok() && *run.state() != fifth);
    let error = run.advance(10).unwrap_err();
    assert_eq!((error.step, error.source, *run.state()), (6, StepError::NotFinite, fifth));
    assert_eq!(run.advance(0), Err(error));
    assert_eq!(run.next(), Some(Err(error)));
    let refused = rk4.trajectory_from(Vector1::zeros(), f64::NAN).advance(1).map(|x| x.x);
    assert!(matches!(refused.map_err(|e| e.source), Err(StepError::StepSize { .. })));
}
