//! Runs along one path of a noise: [`OnPath`].

use collective_integrators::{AnyIntegrator, Integrator, PathAndTime, Start, Step, StepError};
use lie_poisson::{Pair, PathNumber, State, Time};
use momentum_map::LiftError;

/// An integrator of states with the number of their path and the time, whose momenta are without these two. Runs start
/// on the path of a number, at the time 0.
pub(super) struct OnPath<I> {
    pub(super) integrator: I,
    pub(super) path: u64,
}

impl<M, I> OnPath<I>
where
    M: State<Scalar = f64> + Send + Sync + 'static,
    I: Integrator<State = Pair<M, PathAndTime<f64>>, Workspace: Send> + Send + Sync + 'static,
{
    /// Hides the type of the integrator of momenta like this one. The last two coordinates of its states are the number
    /// of the path and the time.
    pub(super) fn erased(self, momentum: &M) -> AnyIntegrator {
        let state = self.on_path(momentum);
        AnyIntegrator::of_states(self, &state, momentum)
    }
}

impl<I> OnPath<I> {
    fn on_path<M: Clone>(&self, momentum: &M) -> Pair<M, PathAndTime<f64>> {
        Pair(momentum.clone(), Pair(PathNumber(self.path as f64), Time(0.0)))
    }
}

impl<M: State<Scalar = f64>, I: Integrator<State = Pair<M, PathAndTime<f64>>>> Integrator
    for OnPath<I>
{
    type State = I::State;
    type Momentum = M;
    type Workspace = I::Workspace;

    fn workspace(&self) -> I::Workspace {
        self.integrator.workspace()
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        self.integrator.step(state, step, workspace)
    }

    fn step_in_place(
        &self,
        state: &mut I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<usize, StepError> {
        self.integrator.step_in_place(state, step, workspace)
    }

    fn forget(&self, workspace: &mut I::Workspace) {
        self.integrator.forget(workspace);
    }

    fn momentum(&self, Pair(momentum, _): &I::State) -> M {
        momentum.clone()
    }
}

impl<M: State<Scalar = f64>, I: Integrator<State = Pair<M, PathAndTime<f64>>>> Start for OnPath<I> {
    fn start(&self, momentum: &M) -> Result<I::State, LiftError> {
        Ok(self.on_path(momentum))
    }
}
