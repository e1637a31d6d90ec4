//! A motion that advances step by step: [`Motion`].

use crate::motions::snapshot::Snapshot;
use collective_integrators::{
    CHECKPOINT, EventError, Events, Integrator, Sample, SampleOf, StepError,
};
use heavytop::Section;
use lie_poisson::{Pair, Quaternion, Se3Dual, State};

/// A motion that advances step by step, and remembers its last step.
pub(crate) trait Motion {
    /// Makes one step of the motion. The state is not changed by a step that fails.
    fn advance(&mut self, step: f64) -> Result<(), StepError>;

    /// Returns the snapshot after the last step.
    fn now(&self) -> Snapshot;

    /// Returns the snapshot a time τ after the beginning of the last step, or `None` if there was no step or if the
    /// step of this size fails.
    fn within(&mut self, tau: f64) -> Option<Snapshot>;

    /// Returns the state in which the last step, of this size, crosses the section.
    fn crossing(&self, section: &Section, step: f64) -> Result<Option<Se3Dual>, EventError>;
}

/// The motion by an integrator whose state is that of (Π, Γ) and the attitude.
pub(crate) struct Running<I: Integrator> {
    integrator: I,
    state: I::State,
    before: Option<I::State>,
    workspace: I::Workspace,
    /// The storage of steps of partial size, so that the steps of the motion do not depend on them.
    aside: I::Workspace,
    made: u64,
}

impl<I: Integrator> Running<I> {
    pub(crate) fn new(integrator: I, state: I::State) -> Self {
        let (workspace, aside) = (integrator.workspace(), integrator.workspace());
        Self { integrator, state, before: None, workspace, aside, made: 0 }
    }
}

impl<I, S> Motion for Running<I>
where
    I: Integrator<State = Pair<S, Quaternion>, Momentum = Se3Dual>,
    S: State<Scalar = f64>,
{
    /// Makes the steps that a [`Trajectory`](collective_integrators::Trajectory) makes, to the last bit.
    fn advance(&mut self, step: f64) -> Result<(), StepError> {
        if self.made.is_multiple_of(CHECKPOINT) {
            self.integrator.forget(&mut self.workspace);
        }
        let next = self.integrator.step(&self.state, step, &mut self.workspace)?;
        self.before = Some(std::mem::replace(&mut self.state, next.point));
        self.made = self.made.saturating_add(1);
        Ok(())
    }

    fn now(&self) -> Snapshot {
        Snapshot::new(self.integrator.momentum(&self.state), self.state.1)
    }

    fn within(&mut self, tau: f64) -> Option<Snapshot> {
        let before = self.before.as_ref()?;
        self.integrator.forget(&mut self.aside);
        let part = self.integrator.step(before, tau, &mut self.aside).ok()?.point;
        Some(Snapshot::new(self.integrator.momentum(&part), part.1))
    }

    fn crossing(&self, section: &Section, step: f64) -> Result<Option<Se3Dual>, EventError> {
        let Some(before) = &self.before else { return Ok(None) };
        let sample = |made: u64, time: f64, state: &I::State| -> SampleOf<I> {
            let momentum = self.integrator.momentum(state);
            Sample { step: made, time, state: state.clone(), momentum, iterations: 0 }
        };
        let first = sample(self.made.saturating_sub(1), 0.0, before);
        let second = sample(self.made, step, &self.state);
        let value = |mu: &Se3Dual| section.value(mu);
        // Two crossings in a step are too rare to look for them in every step of a moving picture.
        if value(&first.momentum) * value(&second.momentum) > 0.0 {
            return Ok(None);
        }
        let (samples, direction) = ([Ok(first), Ok(second)], section.surface().direction);
        let mut events = Events::new(&self.integrator, samples.into_iter(), value, direction);
        Ok(events.next().transpose()?.map(|event| event.momentum))
    }
}
