//! The midpoint rule of an open system with noise without a lift: [`reduced`].

use super::element_field::ElementField;
use crate::algebras::family::Family;
use crate::open_systems::open_system::OpenSystem;
use collective_integrators::{
    AnyIntegrator, AnyTangents, Integrator, NoisyReduced, StageSolver, Start, Step, StepError,
};
use lie_poisson::{Noise, OrbitField, Pair, PathNumber, Point, Real, Time, Vector};
use momentum_map::{DualQuaternions, InvertibleMultipliers, LiftError, Multipliers, Quaternions};

/// The steps of [`NoisyReduced`] from the time 0 on, on the path of a number.
struct OpenReduced<M> {
    steps: NoisyReduced<M, ElementField, ElementField>,
    path: u64,
}

impl<M: InvertibleMultipliers> OpenReduced<M>
where
    ElementField: OrbitField<M::Space> + Noise<M::Space>,
{
    /// Returns the integrator, if the system has noise. A tolerance of the stages is one of the relative error of the motion of a step.
    fn new(multipliers: M, system: &OpenSystem, tolerance: f64) -> Option<Self> {
        let (noise, paths) = (system.terms().noise.as_ref()?, *system.paths()?);
        let [drift, fields] = [(); 2].map(|()| ElementField::new(system.clone()));
        let steps = NoisyReduced::new(multipliers, drift, fields, paths);
        let solver = StageSolver { tolerance, ..*steps.solver() };
        Some(Self { steps: steps.with_rule(noise.rule).with_solver(solver), path: noise.path })
    }
}

/// A momentum, the number of its path, and the time in intervals.
type StateOf<M, T> = Pair<Point<<M as Multipliers>::Space, T>, Pair<PathNumber<T>, Time<T>>>;

impl<M, T> Integrator<T> for OpenReduced<M>
where
    M: InvertibleMultipliers,
    ElementField: OrbitField<M::Space, T> + Noise<M::Space, T>,
    T: Real,
{
    type State = StateOf<M, T>;
    type Momentum = Point<M::Space, T>;
    type Workspace = ();

    fn workspace(&self) {}

    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut (),
    ) -> Result<Step<Self::State>, StepError> {
        self.steps.step(state, step, workspace)
    }

    fn forget(&self, (): &mut ()) {}

    fn momentum(&self, Pair(mu, _): &Self::State) -> Self::Momentum {
        *mu
    }
}

impl<M> Start for OpenReduced<M>
where
    M: InvertibleMultipliers,
    ElementField: OrbitField<M::Space> + Noise<M::Space>,
{
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError> {
        self.steps.start(&Pair(*mu, Pair(PathNumber(self.path as f64), Time(0.0))))
    }
}

/// The coordinates of the states that are no momentum: the number of the path and the time.
const CLOCK: usize = 2;

/// Returns the integrator of a system with noise on so(3)∗ or se(3)∗; `None` for others.
pub(in crate::open_systems) fn reduced(
    system: &OpenSystem,
    tolerance: f64,
) -> Option<AnyIntegrator<dyn AnyTangents>> {
    Some(match system.base().algebra().family {
        Family::Rotations => {
            let integrator = OpenReduced::new(Quaternions, system, tolerance)?;
            AnyIntegrator::of_clocked_states(integrator, (&Vector::zero(), CLOCK), &Vector::zero())
        }
        Family::Motions => {
            let integrator = OpenReduced::new(DualQuaternions, system, tolerance)?;
            AnyIntegrator::of_clocked_states(integrator, (&Vector::zero(), CLOCK), &Vector::zero())
        }
        Family::ManyRotations | Family::Other => return None,
    })
}
