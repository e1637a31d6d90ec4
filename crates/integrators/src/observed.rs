//! Fields, schemes and integrators that say when they are called: [`Observed`].

use crate::error::{IntegrationError, StepError};
use crate::integrators::compensated::Increments;
use crate::integrators::lanes::field_in_lanes::FieldInLanes;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::iteration::lane_problem::{LaneProblem, Outcome};
use crate::schemes::scheme::{Equivariant, Increment, Scheme, Step};
use crate::stage_frame::StageFrame;
use crate::vector_field::VectorField;
use core::ops::Range;
use lie_poisson::{InstructionSet, Pair, Real, State};
use momentum_map::LiftError;

/// A vector field, a scheme or an integrator, with a function that is called before each evaluation of the field or
/// each step.
///
/// All else is passed on, so that the steps keep their bits, predictions and registers. A wrapper of your own passes on
/// the same methods. With stages side by side, one evaluation computes all stages in a register, and the steps by which
/// [`StagesInLanes::widest`](crate::StagesInLanes::widest) and [`Laned::widest`](crate::Laned::widest) choose their
/// registers are observed, too.
///
/// # Example
/// The evaluations of the field in a step of Gauss's method, in the first one and with the predictions of later ones:
/// ```
/// use collective_integrators::{Direct, Integrator, Observed, RungeKutta, from_fn};
/// use nalgebra::Vector2;
/// use std::cell::Cell;
///
/// let evaluations = Cell::new(0);
/// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
/// let counted = Observed::new(pendulum, || evaluations.set(evaluations.get() + 1));
/// let gauss = Direct::new(RungeKutta::gauss(3)?, counted);
/// let (mut z, mut workspace) = (Vector2::new(1.0, 0.0), gauss.workspace());
/// let mut step = || {
///     evaluations.set(0);
///     gauss.step_in_place(&mut z, 0.05, &mut workspace).map(|_| evaluations.get())
/// };
/// let first = step()?;
/// let later = (0..20).map(|_| step()).collect::<Result<Vec<_>, _>>()?;
/// assert!(later[19] < first);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Observed<X, O> {
    inner: X,
    observer: O,
}

impl<X, O: Fn()> Observed<X, O> {
    /// Creates the field, scheme or integrator with a function that is called before each evaluation or step.
    pub fn new(inner: X, observer: O) -> Self {
        Self { inner, observer }
    }

    /// Returns the field, scheme or integrator itself.
    pub fn inner(&self) -> &X {
        &self.inner
    }

    /// Calls the function, and returns the field, scheme or integrator that is about to be called.
    #[cfg_attr(optimised, inline(always))]
    fn observed(&self) -> &X {
        (self.observer)();
        &self.inner
    }
}

/// The function is called before each evaluation.
impl<T: Real, F: VectorField<T>, O: Fn()> VectorField<T> for Observed<F, O> {
    type Point = F::Point;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, z: &F::Point) -> F::Point {
        self.observed().at(z)
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_into(&self, z: &F::Point, value: &mut F::Point) {
        self.observed().at_into(z, value);
    }

    fn derivative(&self, z: &F::Point, v: &F::Point) -> Option<F::Point> {
        self.inner.derivative(z, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn solve_in_lanes(&self, problem: &mut LaneProblem<'_, F::Point>) -> Option<Outcome<F::Point>> {
        self.inner.solve_in_lanes(problem)
    }

    #[cfg_attr(optimised, inline(always))]
    fn stage_frame(&self) -> impl StageFrame<F::Point> {
        self.inner.stage_frame()
    }
}

/// The function is called before each step, also before those of the parts of a composition.
impl<S: Scheme, O: Fn() + Clone> Scheme for Observed<S, O> {
    type Workspace<V: State> = S::Workspace<V>;

    fn workspace<V: State>(&self) -> S::Workspace<V> {
        self.inner.workspace()
    }

    #[cfg_attr(optimised, inline(always))]
    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut S::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        self.observed().increment(field, z, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn refined_increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: (&F::Point, &F::Point),
        step: f64,
        workspace: &mut S::Workspace<F::Point>,
    ) -> Result<Increment<F::Point>, StepError> {
        self.observed().refined_increment(field, z, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn step<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut S::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        self.observed().step(field, z, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn step_in_place<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &mut F::Point,
        step: f64,
        workspace: &mut S::Workspace<F::Point>,
    ) -> Result<usize, StepError> {
        self.observed().step_in_place(field, z, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn temporaries<'a, V: State>(
        &self,
        workspace: &'a mut S::Workspace<V>,
    ) -> Option<&'a mut V::Pool> {
        self.inner.temporaries(workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget<V: State>(&self, workspace: &mut S::Workspace<V>) {
        self.inner.forget(workspace);
    }

    fn order(&self) -> usize {
        self.inner.order()
    }

    fn is_symplectic(&self) -> bool {
        self.inner.is_symplectic()
    }

    fn is_symmetric(&self) -> bool {
        self.inner.is_symmetric()
    }

    fn preserves_quadratic_invariants(&self) -> bool {
        self.inner.preserves_quadratic_invariants()
    }
}

impl<S: Equivariant, O: Fn() + Clone> Equivariant for Observed<S, O> {}

/// The function is called before each step, or once before many steps in one call.
impl<T: Real, I: Integrator<T>, O: Fn()> Integrator<T> for Observed<I, O> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> I::Workspace {
        self.inner.workspace()
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        self.observed().step(state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn step_in_place(
        &self,
        state: &mut I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<usize, StepError> {
        self.observed().step_in_place(state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn advance(
        &self,
        state: &mut I::State,
        step: f64,
        steps: Range<u64>,
        workspace: &mut I::Workspace,
    ) -> Result<usize, IntegrationError> {
        self.observed().advance(state, step, steps, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut I::Workspace) {
        self.inner.forget(workspace);
    }

    fn pin(&self, workspace: &mut I::Workspace) {
        self.inner.pin(workspace);
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.inner.momentum(state)
    }
}

impl<T: Real, I: Start<T>, O: Fn()> Start<T> for Observed<I, O> {
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.inner.start(mu)
    }
}

impl<T: Real, I: Increments<T>, O: Fn()> Increments<T> for Observed<I, O> {
    #[cfg_attr(optimised, inline(always))]
    fn increment(
        &self,
        state: &Pair<I::State, I::State>,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Increment<I::State>, StepError> {
        self.observed().increment(state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn temporaries<'a>(
        &self,
        workspace: &'a mut I::Workspace,
    ) -> Option<&'a mut <I::State as State>::Pool> {
        self.inner.temporaries(workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn gauged(
        &self,
        state: Pair<I::State, I::State>,
        workspace: &I::Workspace,
    ) -> Pair<I::State, I::State> {
        self.inner.gauged(state, workspace)
    }
}

impl<I: FieldInLanes, O: Fn()> FieldInLanes for Observed<I, O> {
    #[cfg_attr(optimised, inline(always))]
    fn step_in_lanes(
        &self,
        instructions: InstructionSet,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        self.observed().step_in_lanes(instructions, state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn increment_in_lanes(
        &self,
        instructions: InstructionSet,
        state: &Pair<I::State, I::State>,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Increment<I::State>, StepError> {
        self.observed().increment_in_lanes(instructions, state, step, workspace)
    }
}
