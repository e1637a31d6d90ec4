//! Integrators that can be resumed after a few steps: [`Renewed`].

use collective_integrators::{CHECKPOINT, Integrator, Start, Step, StepError};
use lie_poisson::Real;
use momentum_map::LiftError;

/// The number of coordinates times steps after which an integrator of a large system forgets what it knows of earlier steps:
/// seconds of work, so that forgetting costs little, and an interrupted run can be resumed soon.
const WORK: usize = 1 << 24;

/// Returns the number of steps after which a run of a system of this dimension can be resumed, a power of two.
pub(super) fn resumable_after(dimension: usize) -> u64 {
    let steps = (WORK / dimension.max(1)).max(1) as u64;
    (1 << steps.ilog2()).min(CHECKPOINT)
}

/// An integrator that forgets earlier steps after each `period` steps, so that it can be resumed there with the same bits.
pub(super) struct Renewed<I> {
    pub(super) integrator: I,
    pub(super) period: u64,
}

/// The storage of a step, and the number of steps since it was forgotten.
pub(super) struct RenewedWorkspace<W> {
    inner: W,
    made: u64,
}

impl<T: Real, I: Integrator<T>> Integrator<T> for Renewed<I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = RenewedWorkspace<I::Workspace>;

    fn workspace(&self) -> Self::Workspace {
        RenewedWorkspace { inner: self.integrator.workspace(), made: 0 }
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        Step::of_copy(state, |state| self.step_in_place(state, step, workspace))
    }

    fn step_in_place(
        &self,
        state: &mut I::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        if workspace.made == self.period {
            self.forget(workspace);
        }
        workspace.made += 1;
        self.integrator.step_in_place(state, step, &mut workspace.inner)
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        workspace.made = 0;
        self.integrator.forget(&mut workspace.inner);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        self.integrator.pin(&mut workspace.inner);
    }

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.integrator.momentum(state)
    }
}

impl<I: Start> Start for Renewed<I> {
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.integrator.start(mu)
    }
}
