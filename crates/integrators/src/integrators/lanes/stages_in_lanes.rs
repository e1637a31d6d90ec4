//! Integrators that compute the stages of a step side by side: [`StagesInLanes`].

use crate::error::StepError;
use crate::integrators::compensated::{Compensated, Increments};
use crate::integrators::lanes::fastest_set::FastestSet;
use crate::integrators::lanes::field_in_lanes::FieldInLanes;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::schemes::scheme::{Increment, Step};
use lie_poisson::{InstructionSet, MissingInstructions, Pair, State};
use momentum_map::LiftError;

/// The number of steps of a run that is timed: the first one has no prediction to start from.
const TRIAL_STEPS: usize = 4;

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
/// integrator alone uses the newest ones. The two results therefore differ by round-off. If the iteration does not
/// converge, Newton's iteration follows as usual.
///
/// [`new`](Self::new) uses the lanes that every processor has. [`widest`](Self::widest) uses wider registers of the
/// current processor where they are faster, which the first step measures: a field that fulfils the
/// [rules of wide registers](crate::Laned#speed-of-wide-registers) gains. The results of both are the same to the last
/// bit. To advance many states at once, [`Laned`](crate::Laned) is faster: it computes one state in each lane.
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
    instructions: FastestSet,
}

impl<I: FieldInLanes> StagesInLanes<I> {
    /// Creates the integrator on the lanes that every processor has.
    pub fn new(integrator: I) -> Self {
        Self { integrator, instructions: FastestSet::given(InstructionSet::Portable) }
    }

    /// Creates the integrator on the registers of this processor that are the fastest, as the first step shows. To find
    /// that out, it makes a few more steps, in storage of their own. The steps are bit-identical to those of
    /// [`new`](Self::new).
    pub fn widest(integrator: I) -> Self {
        Self { integrator, instructions: FastestSet::up_to(InstructionSet::detected()) }
    }

    /// Creates the integrator on the widest registers of this processor, without a measurement. It is for fields that are
    /// known to be faster there. The steps are bit-identical to those of [`new`](Self::new).
    pub fn detected(integrator: I) -> Self {
        Self { integrator, instructions: FastestSet::given(InstructionSet::detected()) }
    }

    /// Replaces the instruction set. No other set is used, even if it is faster.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks them.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self { instructions: FastestSet::given(set.if_available()?), ..self })
    }

    /// Returns the instruction set that the steps use. For [`widest`](Self::widest) it may become a narrower one in the
    /// first step.
    pub fn instructions(&self) -> InstructionSet {
        self.instructions.current()
    }

    /// Returns the integrator that computes one stage after the other.
    pub fn integrator(&self) -> &I {
        &self.integrator
    }

    /// Returns the integrator with [`Compensated`] summation.
    pub fn compensated(self) -> Compensated<Self> {
        Compensated(self)
    }

    /// Returns the instruction set of a step from a state. The first step of a motion measures it.
    #[cfg_attr(optimised, inline(always))]
    fn instructions_from(&self, state: &I::State, step: f64) -> InstructionSet {
        self.instructions.find(
            || StepError::check_start(state, step).is_ok(),
            |set| self.try_steps(set, state, step),
        )
    }

    /// Makes a few steps in the registers of an instruction set, to be timed.
    fn try_steps(&self, set: InstructionSet, state: &I::State, step: f64) {
        let (mut end, mut workspace) = (state.clone(), self.integrator.workspace());
        for _ in 0..TRIAL_STEPS {
            match self.step_on(set, &end, step, &mut workspace) {
                Ok(made) => end = made.point,
                Err(_) => break,
            }
        }
    }

    /// Makes a step in the registers of an instruction set. It is compiled once, for steps and for trials.
    #[inline(never)]
    fn step_on(
        &self,
        set: InstructionSet,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        self.integrator.step_in_lanes(set, state, step, workspace)
    }
}

impl<I: FieldInLanes> Integrator for StagesInLanes<I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> Self::Workspace {
        self.integrator.workspace()
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        self.step_on(self.instructions_from(state, step), state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.integrator.forget(workspace);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        self.integrator.pin(workspace);
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, state: &Self::State) -> Self::Momentum {
        self.integrator.momentum(state)
    }
}

impl<I: FieldInLanes> Increments for StagesInLanes<I> {
    #[cfg_attr(optimised, inline(always))]
    fn increment(
        &self,
        state: &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        let instructions = self.instructions_from(&state.0, step);
        self.integrator.increment_in_lanes(instructions, state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn temporaries<'a>(
        &self,
        workspace: &'a mut Self::Workspace,
    ) -> Option<&'a mut <Self::State as State>::Pool> {
        self.integrator.temporaries(workspace)
    }

    #[cfg_attr(optimised, inline(always))]
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
