//! A motion that advances step by step: [`Motion`].

use crate::motions::damped::{Damped, Frictions, momentum};
use crate::motions::snapshot::Snapshot;
use collective_integrators::{
    AnyState, AnyWorkspace, CHECKPOINT, EventError, Events, Integrator, Sample, SampleOf, StepError,
};
use heavytop::Section;
use heavytop::methods::attitude_of;
use lie_poisson::Se3Dual;

/// A motion of a top with its attitude, which is in the last four coordinates of the states. It remembers its last step.
pub(crate) struct Motion {
    integrator: Damped,
    state: AnyState,
    before: Option<AnyState>,
    workspace: AnyWorkspace,
    /// The storage of steps of partial size, so that the steps of the motion do not depend on them.
    aside: AnyWorkspace,
    made: u64,
}

impl Motion {
    pub(crate) fn new(integrator: Damped, state: AnyState) -> Self {
        let [workspace, aside] = [(); 2].map(|()| integrator.workspace());
        Self { integrator, state, before: None, workspace, aside, made: 0 }
    }

    /// Makes one step of the motion, the one that a [`Trajectory`](collective_integrators::Trajectory) makes, to the last
    /// bit. The state is not changed by a step that fails. Returns what the friction has done.
    pub(crate) fn advance(&mut self, step: f64) -> Result<Option<Frictions>, StepError> {
        if self.made.is_multiple_of(CHECKPOINT) {
            self.integrator.forget(&mut self.workspace);
        }
        let (next, frictions) =
            self.integrator.step_with_friction(&self.state, step, &mut self.workspace)?;
        self.before = Some(std::mem::replace(&mut self.state, next.point));
        self.made = self.made.saturating_add(1);
        Ok(frictions)
    }

    /// Returns the snapshot after the last step.
    pub(crate) fn now(&self) -> Snapshot {
        self.snapshot(&self.state)
    }

    /// Returns the snapshot a time τ after the beginning of the last step, and what the friction has done until then, or
    /// `None` if there was no step or if the step of this size fails.
    pub(crate) fn within(&mut self, tau: f64) -> Option<(Snapshot, Option<Frictions>)> {
        let before = self.before.as_ref()?;
        self.integrator.forget(&mut self.aside);
        let (part, frictions) =
            self.integrator.step_with_friction(before, tau, &mut self.aside).ok()?;
        Some((self.snapshot(&part.point), frictions))
    }

    /// Returns the state in which the last step, of this size, crosses the section.
    pub(crate) fn crossing(
        &self,
        section: &Section,
        step: f64,
    ) -> Result<Option<Se3Dual>, EventError> {
        let Some(before) = &self.before else { return Ok(None) };
        let sample = |made: u64, time: f64, state: &AnyState| -> SampleOf<Damped> {
            let momentum = self.integrator.momentum(state);
            Sample { step: made, time, state: state.clone(), momentum, iterations: 0 }
        };
        let first = sample(self.made.saturating_sub(1), 0.0, before);
        let second = sample(self.made, step, &self.state);
        let value = |mu: &AnyState| section.value(&momentum(mu));
        // Two crossings in a step are too rare to look for them in every step of a moving picture.
        if value(&first.momentum) * value(&second.momentum) > 0.0 {
            return Ok(None);
        }
        let (samples, direction) = ([Ok(first), Ok(second)], section.surface().direction);
        let mut events = Events::new(&self.integrator, samples.into_iter(), value, direction);
        Ok(events.next().transpose()?.map(|event| momentum(&event.momentum)))
    }

    fn snapshot(&self, state: &AnyState) -> Snapshot {
        let mu = momentum(&self.integrator.momentum(state));
        Snapshot::new(mu, attitude_of(state.as_slice()))
    }
}
