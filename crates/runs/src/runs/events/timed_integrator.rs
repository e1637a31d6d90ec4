//! An integrator whose momenta have the time beside them: [`TimedIntegrator`].

use collective_integrators::{
    AnyIntegrator, AnyState, Integrator, Sample, SampleOf, Step, StepError,
};
use lie_poisson::{Pair, Time};

/// An integrator whose momenta have the time beside them, so that events may be zeros of functions of both.
///
/// The time of a step of partial size is that of the sample from which it is made and the size. No rounding adds up, since
/// [`sample`](Self::sample) takes the time of each sample anew.
///
/// # Example
/// The zeros of cos t, along a run whose system has nothing to do with it:
/// ```
/// use collective_integrators::{
///     AnyIntegrator, AnyState, Direct, Direction, EventSearch, RungeKutta, Start, from_fn,
/// };
/// use lie_poisson::Pair;
/// use lie_poisson_runs::{TimedIntegrator, TimedState};
/// use nalgebra::Vector1;
/// use std::f64::consts::FRAC_PI_2;
/// let decay = Direct::new(RungeKutta::rk4(), from_fn(|z: &Vector1<f64>| -z));
/// let decay = AnyIntegrator::new(decay, 1);
/// let timed = TimedIntegrator::new(&decay);
/// let mut search = EventSearch::new(&timed, |Pair(_, t): &TimedState| t.0.cos(), Direction::Both);
/// let mut times = Vec::new();
/// for sample in decay.trajectory(&AnyState::from_slice(&[1.0]), 0.1)?.take(101) {
///     let events = search.observe(&TimedIntegrator::sample(&sample?))?;
///     times.extend(events.into_iter().flatten().map(|event| event.time));
/// }
/// assert_eq!(times.len(), 3);
/// assert!(times.iter().zip([1.0, 3.0, 5.0]).all(|(t, k)| (t - k * FRAC_PI_2).abs() < 1e-14));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TimedIntegrator<'a>(&'a AnyIntegrator);

/// A state or a momentum, and the time, s.
pub type TimedState = Pair<AnyState, Time>;

impl<'a> TimedIntegrator<'a> {
    /// Creates the integrator that makes the steps of another one.
    #[must_use]
    pub const fn new(integrator: &'a AnyIntegrator) -> Self {
        Self(integrator)
    }

    /// Returns a sample of the integrator with its time.
    #[must_use]
    pub fn sample(sample: &SampleOf<AnyIntegrator>) -> SampleOf<Self> {
        let Sample { step, time, ref state, ref momentum, iterations } = *sample;
        let timed = |state: &AnyState| Pair(state.clone(), Time(time));
        Sample { step, time, state: timed(state), momentum: timed(momentum), iterations }
    }

    /// Returns the sample of the integrator, without the time in its state.
    #[must_use]
    pub fn untimed(sample: SampleOf<Self>) -> SampleOf<AnyIntegrator> {
        let Sample { step, time, state: Pair(state, _), momentum: Pair(momentum, _), iterations } =
            sample;
        Sample { step, time, state, momentum, iterations }
    }
}

impl Integrator for TimedIntegrator<'_> {
    type State = TimedState;
    type Momentum = TimedState;
    type Workspace = <AnyIntegrator as Integrator>::Workspace;

    fn workspace(&self) -> Self::Workspace {
        Integrator::<f64>::workspace(self.0)
    }

    fn step(
        &self,
        Pair(state, time): &TimedState,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<TimedState>, StepError> {
        let Step { point, iterations } = self.0.step(state, step, workspace)?;
        Ok(Step { point: Pair(point, Time(time.0 + step)), iterations })
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        Integrator::<f64>::forget(self.0, workspace);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        Integrator::<f64>::pin(self.0, workspace);
    }

    fn momentum(&self, Pair(state, time): &TimedState) -> TimedState {
        Pair(self.0.momentum(state), *time)
    }
}
