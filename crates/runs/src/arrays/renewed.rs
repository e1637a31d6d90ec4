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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use collective_integrators::CollectiveSites;
    use heavytop::methods::SchemeName;
    use lie_poisson::Covector;
    use lie_poisson_systems::HeisenbergLattice;
    use momentum_map::HOPF;
    use nalgebra::Vector3;

    /// A run that continues from a multiple of the period has the bits of the uninterrupted one, and one that continues from
    /// another step has not.
    #[test]
    fn a_run_continues_from_multiples_of_the_period() {
        let scheme = SchemeName::Gauss(4).runge_kutta(0.0).unwrap().unwrap();
        let ring =
            HeisenbergLattice::new([6, 1, 1]).unwrap().with_exchange([1, 0, 0], 1.0).unwrap();
        let collective = CollectiveSites::new(scheme, HOPF, ring);
        let renewed = Renewed { integrator: collective, period: 8 };
        let spin =
            |i: u32| Vector3::new(f64::from(i).sin(), f64::from(i * i).cos(), 0.4).normalize();
        let mu = Covector((0..6).map(spin).collect());
        let after = |from, steps: usize| {
            let (mut state, mut workspace): (_, RenewedWorkspace<_>) = (from, renewed.workspace());
            for _ in 0..steps {
                renewed.step_in_place(&mut state, 0.3, &mut workspace).unwrap();
            }
            state
        };
        let start = renewed.start(&mu).unwrap();
        let whole = after(start.clone(), 200);
        assert!(after(after(start.clone(), 16), 184) == whole);
        assert!(after(after(start.clone(), 8), 192) == whole);
        assert!(after(after(start, 11), 189) != whole);
    }

    #[test]
    fn large_systems_are_renewed_more_often() {
        // 2²⁴ over the dimension, as a power of two, and at most the steps from checkpoint to checkpoint.
        let periods = [1, 1 << 14, 1 << 15, 225_000, 3_000_000, usize::MAX].map(resumable_after);
        assert_eq!(periods, [1024, 1024, 512, 64, 4, 1]);
    }
}
