//! Runs of spins along one path of a noise: [`LatticePaths`].

use crate::arrays::sites::open_lattice::OpenLattice;
use crate::arrays::sites::sites_system::Momenta;
use collective_integrators::{AnyIntegrator, Integrator, PathAndTime, Start, Step, StepError};
use lie_poisson::{Pair, State};
use lie_poisson_systems::{LangevinSpins, LangevinWorkspace};
use momentum_map::LiftError;
use nalgebra::Vector1;

/// Spins, the number of their path, and the time in intervals of the noise.
type SpinsOnPath = Pair<Momenta, PathAndTime<f64>>;

/// An integrator of spins whose momenta are the spins alone. Runs start on the path of a number, at the time 0.
pub(super) struct LatticePaths {
    pub(super) langevin: LangevinSpins<OpenLattice>,
    pub(super) path: u64,
}

impl LatticePaths {
    /// Hides the type of the integrator of so many spins. The last two coordinates of its states are the number of the path
    /// and the time.
    pub(super) fn erased(self, spins: usize) -> AnyIntegrator {
        let spins: Momenta = State::zeros_of(&spins);
        let state = self.on_path(&spins);
        AnyIntegrator::of_states(self, &state, &spins)
    }

    fn on_path(&self, spins: &Momenta) -> SpinsOnPath {
        Pair(spins.clone(), Pair(Vector1::new(self.path as f64), Vector1::new(0.0)))
    }
}

impl Integrator for LatticePaths {
    type State = SpinsOnPath;
    type Momentum = Momenta;
    type Workspace = LangevinWorkspace;

    fn workspace(&self) -> LangevinWorkspace {
        self.langevin.workspace()
    }

    fn step(
        &self,
        state: &SpinsOnPath,
        step: f64,
        workspace: &mut LangevinWorkspace,
    ) -> Result<Step<SpinsOnPath>, StepError> {
        self.langevin.step(state, step, workspace)
    }

    fn step_in_place(
        &self,
        state: &mut SpinsOnPath,
        step: f64,
        workspace: &mut LangevinWorkspace,
    ) -> Result<usize, StepError> {
        self.langevin.step_in_place(state, step, workspace)
    }

    fn forget(&self, workspace: &mut LangevinWorkspace) {
        self.langevin.forget(workspace);
    }

    fn momentum(&self, Pair(spins, _): &SpinsOnPath) -> Momenta {
        spins.clone()
    }
}

impl Start for LatticePaths {
    fn start(&self, spins: &Momenta) -> Result<SpinsOnPath, LiftError> {
        Ok(self.on_path(spins))
    }
}
