//! Integrators that compute the stages of a step side by side: [`StagesInLanes`].

use crate::dual::lanes::field_in_lanes::FieldInLanes;
use crate::{Compensated, Increment, Increments, Integrator, Start, Step, StepError};
use lie_poisson::{InstructionSet, MissingInstructions, Pair, State};
use momentum_map::LiftError;

/// An integrator of one state that computes the stages of a step side by side, one stage in each SIMD lane of a
/// register.
///
/// The stage equations are those of the wrapped integrator:
///
/// ```text
/// k_i = X(z + h Σ_j a_ij k_j),    i = 1, …, s
/// ```
///
/// A sweep evaluates X once for each register, for several i at a time, instead of s times over `f64`. Implicit
/// [`RungeKutta`](crate::RungeKutta) methods with two to eight stages are computed in this way, also as parts of a
/// [`Composition`](crate::Composition). For other methods a step is bit-identical to that of the integrator alone.
///
/// The stages solve the same equations to the same accuracy. A sweep uses the k_j of the previous sweep, whereas the
/// integrator alone uses the newest ones. The two results therefore differ by round-off, and so do those on two
/// instruction sets. If the iteration does not converge, Newton's iteration follows as usual.
///
/// [`new`](Self::new) uses the lanes that every processor has. [`widest`](Self::widest) uses the widest registers of
/// the current processor, for a field that fulfils the [rules of wide registers](crate::Laned#speed-of-wide-registers).
/// To advance many states at once, [`Laned`](crate::Laned) is faster: it computes one state in each lane.
///
/// Source: Antoñana, Makazaga & Murua, *SIMD-vectorized implicit symplectic integrators can outperform explicit ones*
/// (2024).
///
/// # Example
/// A pendulum dq/dt = p, dp/dt = −sin q:
/// ```
/// use collective_integrators::{Direct, RungeKutta, StagesInLanes, Start, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
///
/// struct Pendulum;
/// impl<T: Real> VectorField<T> for Pendulum {
///     type Point = Vector2<T>;
///     #[inline(always)]
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, -z.x.sin())
///     }
/// }
/// let alone = Direct::new(RungeKutta::gauss(8)?, Pendulum);
/// let start = Vector2::new(1.0, 0.0);
/// let expected = alone.after(&start, 0.25, 400)?.state;
/// let side_by_side = StagesInLanes::widest(alone);
/// assert!((side_by_side.after(&start, 0.25, 400)?.state - expected).norm() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StagesInLanes<I> {
    integrator: I,
    instructions: InstructionSet,
}

impl<I: FieldInLanes> StagesInLanes<I> {
    /// Creates the integrator on the lanes that every processor has.
    pub fn new(integrator: I) -> Self {
        Self { integrator, instructions: InstructionSet::Portable }
    }

    /// Creates the integrator on the widest instruction set that this processor has. Four stages or fewer are computed
    /// in registers of four lanes at most.
    pub fn widest(integrator: I) -> Self {
        Self { integrator, instructions: InstructionSet::detected() }
    }

    /// Replaces the instruction set. Steps on different sets differ by round-off.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks them.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self { instructions: set.if_available()?, ..self })
    }

    /// Returns the instruction set that the steps use.
    pub fn instructions(&self) -> InstructionSet {
        self.instructions
    }

    /// Returns the integrator that computes one stage after the other.
    pub fn integrator(&self) -> &I {
        &self.integrator
    }

    /// Returns the integrator with [`Compensated`] summation.
    pub fn compensated(self) -> Compensated<Self> {
        Compensated(self)
    }
}

impl<I: FieldInLanes> Integrator for StagesInLanes<I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> Self::Workspace {
        self.integrator.workspace()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        self.integrator.step_in_lanes(self.instructions, state, step, workspace)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.integrator.forget(workspace);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        self.integrator.pin(workspace);
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn momentum(&self, state: &Self::State) -> Self::Momentum {
        self.integrator.momentum(state)
    }
}

impl<I: FieldInLanes> Increments for StagesInLanes<I> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn increment(
        &self,
        state: &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        self.integrator.increment_in_lanes(self.instructions, state, step, workspace)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn temporaries<'a>(
        &self,
        workspace: &'a mut Self::Workspace,
    ) -> Option<&'a mut <Self::State as State>::Pool> {
        self.integrator.temporaries(workspace)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn gauged(
        &self,
        state: Pair<Self::State, Self::State>,
        workspace: &Self::Workspace,
    ) -> Pair<Self::State, Self::State> {
        self.integrator.gauged(state, workspace)
    }
}

impl<I: FieldInLanes + Start> Start for StagesInLanes<I> {
    /// Returns the state from which the integrator alone starts.
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError> {
        self.integrator.start(mu)
    }
}
