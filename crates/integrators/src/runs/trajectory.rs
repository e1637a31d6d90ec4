//! Trajectories as iterators.

use crate::{IntegrationError, Integrator, StepError};
use lie_poisson::Real;

/// A point of a trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<S, M> {
    /// The number of steps made; 0 for the initial state.
    pub step: u64,
    /// t = step · h
    pub time: f64,
    /// The state that is advanced.
    pub state: S,
    /// The momentum μ read off it.
    pub momentum: M,
    /// Iterations of the stage solver in the step that led here.
    pub iterations: usize,
}

/// The sample type of an integrator's trajectories.
pub type SampleOf<I, T = f64> = Sample<<I as Integrator<T>>::State, <I as Integrator<T>>::Momentum>;

/// A step whose number is a multiple of this begins without the memory of the steps before, from
/// which implicit methods [guess](crate::StageSolver) their stages.
pub const CHECKPOINT: u64 = 1024;

/// The endless trajectory of an integrator: the initial state, then one sample per step.
///
/// Once a step fails, every further item is its error: no adaptor that skips items, such as `nth` or
/// `step_by`, can lose it. The iterator never returns `None`. Bound it by `take`, and leave a loop at
/// the first error, as `?` and `collect::<Result<…>>` do; adaptors that pass errors over, such as
/// `flatten`, look for the next sample for ever. [`Start::after`](crate::Start::after) returns one
/// sample. After the first item nothing is allocated.
///
/// A run can be [resumed](Integrator::trajectory_resumed) from any of its samples; from one whose
/// number is a multiple of [`CHECKPOINT`] it goes on bit for bit as if it had not been interrupted.
///
/// # Example
/// ```
/// use collective_integrators::{CHECKPOINT, Direct, Integrator, RungeKutta, from_fn};
/// use nalgebra::Vector2;
/// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
/// let gauss = Direct::new(RungeKutta::gauss(2)?, pendulum);
/// let mut run = gauss.trajectory_from(Vector2::new(1.0, 0.0), 0.1).skip(CHECKPOINT as usize);
/// let saved = run.next().unwrap()?;
/// let resumed = gauss.trajectory_resumed(saved.state, saved.step, 0.1);
/// for (a, b) in run.zip(resumed.skip(1)).take(100) {
///     let (a, b) = (a?, b?);
///     assert_eq!((a.step, a.time, a.state), (b.step, b.time, b.state));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Trajectory<'a, I: Integrator<T>, T: Real = f64> {
    integrator: &'a I,
    workspace: I::Workspace,
    step: f64,
    upcoming: Upcoming<I::State>,
}

#[derive(Debug)]
enum Upcoming<S> {
    First(S, u64),
    After(S, u64),
    Failed(IntegrationError),
}

impl<'a, I: Integrator<T>, T: Real> Trajectory<'a, I, T> {
    pub(crate) fn new(integrator: &'a I, state: I::State, made: u64, step: f64) -> Self {
        let workspace = integrator.workspace();
        Self { integrator, workspace, step, upcoming: Upcoming::First(state, made) }
    }

    /// The sample `steps` items after the next one.
    pub(crate) fn after(mut self, steps: u64) -> Result<SampleOf<I, T>, IntegrationError> {
        for _ in 0..steps {
            self.advance()?;
        }
        self.advance()
    }

    /// The next sample, or the error at which the trajectory ended.
    #[inline]
    fn advance(&mut self) -> Result<SampleOf<I, T>, IntegrationError> {
        let next = match self.upcoming {
            Upcoming::First(state, made) => self.first(state, made),
            Upcoming::After(state, made) => self.following(&state, made),
            Upcoming::Failed(error) => Err(error),
        };
        self.upcoming = match &next {
            Ok(sample) => Upcoming::After(sample.state, sample.step),
            Err(error) => Upcoming::Failed(*error),
        };
        next
    }

    fn first(&self, state: I::State, made: u64) -> Result<SampleOf<I, T>, IntegrationError> {
        match StepError::check_start(&state, self.step) {
            Ok(()) => Ok(self.sample(state, made, 0)),
            Err(refused) => Err(IntegrationError::after(made, self.step, refused)),
        }
    }

    #[inline]
    fn following(
        &mut self,
        state: &I::State,
        made: u64,
    ) -> Result<SampleOf<I, T>, IntegrationError> {
        let number = made.checked_add(1).ok_or(StepError::Uncountable);
        if made.is_multiple_of(CHECKPOINT) {
            self.integrator.forget(&mut self.workspace);
        }
        let next = number.and_then(|number| {
            let next = self.integrator.step(state, self.step, &mut self.workspace)?;
            Ok(self.sample(next.point, number, next.iterations))
        });
        next.map_err(|source| IntegrationError::after(made, self.step, source))
    }

    #[inline]
    fn sample(&self, state: I::State, step: u64, iterations: usize) -> SampleOf<I, T> {
        let momentum = self.integrator.momentum(&state);
        Sample { step, time: step as f64 * self.step, state, momentum, iterations }
    }
}

impl<I: Integrator<T>, T: Real> Iterator for Trajectory<'_, I, T> {
    type Item = Result<SampleOf<I, T>, IntegrationError>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        Some(self.advance())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Direct, RunError, RungeKutta, Start, VectorField, from_fn};
    use nalgebra::{Vector1, Vector2};

    /// ẋ = x² from 1 blows up at t = 1.
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

    #[test]
    fn one_sample_after_many_steps() {
        let integrator = blow_up();
        let run: Vec<_> = integrator.trajectory_from(Vector1::x(), 0.05).take(40).collect();
        for (n, sample) in (0..).zip(run) {
            let alone = integrator.after(&Vector1::x(), 0.05, n);
            assert_eq!(alone, sample.map_err(RunError::Integration));
        }
    }

    #[test]
    fn a_start_that_is_not_finite_is_refused() {
        let rk4 = Direct::new(RungeKutta::rk4(), from_fn(|z: &Vector2<f64>| -*z));
        let start = Vector2::new(1.0, 2.0);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let nowhere = Vector2::new(1.0, bad);
            let of_start = |e: StepError| matches!(e, StepError::NotFiniteStart { coordinate: 1, size } if !size.is_finite());
            let of_step =
                |e: StepError| matches!(e, StepError::StepSize { step } if !step.is_finite());
            let cases: [(_, _, &dyn Fn(StepError) -> bool); 2] =
                [(nowhere, 0.5, &of_start), (start, bad, &of_step)];
            for (state, step, named) in cases {
                let fits = |e: IntegrationError, made: u64| e.step == made + 1 && named(e.source);
                let at_start =
                    |e| matches!(e, RunError::Integration(e) if fits(e, 0) && e.time == 0.0);
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
        let mut run = rk4.trajectory_resumed(Vector2::x(), u64::MAX, 1e-9);
        assert!(run.next().is_some_and(|s| s.is_ok()) && run.next().is_some_and(|s| s.is_err()));
    }
}
