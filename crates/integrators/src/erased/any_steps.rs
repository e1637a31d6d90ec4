//! The steps of an integrator behind a pointer: [`AnySteps`], [`AnyStart`] and [`AnyTangents`].

use super::any_state::{AnyState, BlockEnds};
use crate::error::{IntegrationError, StepError};
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::schemes::scheme::Step;
use core::any::Any;
use core::fmt;
use core::ops::Range;
use lie_poisson::{DualNumber, Real, State};
use momentum_map::LiftError;

/// The storage of the steps of any integrator.
pub struct AnyWorkspace(Box<dyn Any>);

impl AnyWorkspace {
    /// Returns the storage as that of an integrator. That of another integrator is replaced.
    fn of<I: Integrator<T, Workspace: 'static>, T: Real>(
        &mut self,
        integrator: &I,
    ) -> &mut I::Workspace {
        if !self.0.is::<I::Workspace>() {
            self.0 = Box::new(integrator.workspace());
        }
        match self.0.downcast_mut() {
            Some(workspace) => workspace,
            None => unreachable!("the storage has this type"),
        }
    }
}

impl fmt::Debug for AnyWorkspace {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("AnyWorkspace")
    }
}

/// The steps of an integrator over a scalar, whatever its type: the methods of [`Integrator`] on [`AnyState`]s.
pub trait AnySteps<T: Real>: Send + Sync {
    /// Allocates the storage of a step.
    fn workspace(&self) -> AnyWorkspace;

    /// Replaces the state by the state after one step, and returns the number of iterations.
    ///
    /// # Errors
    /// Returns the errors of [`Integrator::step_in_place`].
    fn step_in_place(
        &self,
        state: &mut AnyState<T>,
        step: f64,
        workspace: &mut AnyWorkspace,
    ) -> Result<usize, StepError>;

    /// Advances a state over many steps in one call.
    ///
    /// # Errors
    /// Returns the errors of [`Integrator::advance`].
    fn advance(
        &self,
        state: &mut AnyState<T>,
        step: f64,
        steps: Range<u64>,
        workspace: &mut AnyWorkspace,
    ) -> Result<usize, IntegrationError>;

    /// Forgets the earlier steps.
    fn forget(&self, workspace: &mut AnyWorkspace);

    /// Moves no state along its fibre any more.
    fn pin(&self, workspace: &mut AnyWorkspace);

    /// Returns the momentum of a state.
    fn momentum(&self, state: &AnyState<T>) -> AnyState<T>;
}

/// The steps of an integrator that can start from a momentum.
pub trait AnyStart: AnySteps<f64> {
    /// Returns a state that represents a momentum.
    ///
    /// # Errors
    /// Returns the errors of [`Start::start`].
    fn start(&self, mu: &AnyState) -> Result<AnyState, LiftError>;

    /// Returns the dimension of the states.
    fn state_dimension(&self) -> usize;

    /// Returns the number of coordinates of the states along which there are tangent vectors.
    fn tangent_dimension(&self) -> usize;

    /// Returns whether the states are momenta, with or without a clock.
    fn states_are_momenta(&self) -> bool;
}

/// The steps of an integrator that has tangent maps.
pub trait AnyTangents: AnyStart + AnySteps<DualNumber> {}

impl<I: AnyStart + AnySteps<DualNumber>> AnyTangents for I {}

/// An integrator on momenta whose first coordinates are those of the system. The others are zero.
pub(super) struct Erased<I, S, M> {
    pub(super) integrator: I,
    /// The shapes of the states and of the momenta.
    pub(super) shapes: (S, M),
    /// The dimensions of the states and of the momenta.
    pub(super) dimensions: (usize, usize),
    /// The number of the last coordinates of the states that belong to a clock.
    pub(super) clock: usize,
    /// The blocks of the coordinates of the system.
    pub(super) momenta: BlockEnds,
}

impl<I, S, M> Erased<I, S, M> {
    /// Returns the state with these coordinates in the type of the integrator.
    fn typed<T: Real>(&self, state: &AnyState<T>) -> I::State
    where
        I: Integrator<T, State: State<Shape = S>>,
    {
        let mut typed = I::State::zeros_of(&self.shapes.0);
        let values = state.as_slice();
        // The compiler knows the number of coordinates in the first case.
        match values.get(..typed.dimension()) {
            Some(all) => typed.set_coordinates(|i| all.get(i).copied().unwrap_or_else(T::zero)),
            None => typed.set_coordinates(|i| values.get(i).copied().unwrap_or_else(T::zero)),
        }
        typed
    }
}

/// An integrator whose step is compiled once, for single steps and for many.
struct Once<'a, I>(&'a I);

impl<T: Real, I: Integrator<T>> Integrator<T> for Once<'_, I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> I::Workspace {
        self.0.workspace()
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        let mut point = state.clone();
        let iterations = self.step_in_place(&mut point, step, workspace)?;
        Ok(Step { point, iterations })
    }

    #[inline(never)]
    fn step_in_place(
        &self,
        state: &mut I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<usize, StepError> {
        self.0.step_in_place(state, step, workspace)
    }

    fn forget(&self, workspace: &mut I::Workspace) {
        self.0.forget(workspace);
    }

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.0.momentum(state)
    }
}

impl<I, S, M, T: Real> AnySteps<T> for Erased<I, S, M>
where
    I: Integrator<T, State: State<Shape = S>> + Send + Sync + 'static,
    S: Send + Sync,
    M: Send + Sync,
{
    fn workspace(&self) -> AnyWorkspace {
        AnyWorkspace(Box::new(self.integrator.workspace()))
    }

    fn step_in_place(
        &self,
        state: &mut AnyState<T>,
        step: f64,
        workspace: &mut AnyWorkspace,
    ) -> Result<usize, StepError> {
        let workspace = workspace.of::<I, T>(&self.integrator);
        let mut typed = self.typed(state);
        let iterations = Once(&self.integrator).step_in_place(&mut typed, step, workspace)?;
        state.copy_entries(&typed);
        Ok(iterations)
    }

    fn advance(
        &self,
        state: &mut AnyState<T>,
        step: f64,
        steps: Range<u64>,
        workspace: &mut AnyWorkspace,
    ) -> Result<usize, IntegrationError> {
        let workspace = workspace.of::<I, T>(&self.integrator);
        let mut typed = self.typed(state);
        let outcome = Once(&self.integrator).advance(&mut typed, step, steps, workspace);
        state.copy_entries(&typed);
        outcome
    }

    fn forget(&self, workspace: &mut AnyWorkspace) {
        self.integrator.forget(workspace.of::<I, T>(&self.integrator));
    }

    fn pin(&self, workspace: &mut AnyWorkspace) {
        self.integrator.pin(workspace.of::<I, T>(&self.integrator));
    }

    fn momentum(&self, state: &AnyState<T>) -> AnyState<T> {
        let momentum = self.integrator.momentum(&self.typed(state));
        AnyState::with_blocks(&momentum, self.momenta)
    }
}

impl<I, S, M> AnyStart for Erased<I, S, M>
where
    I: Start<State: State<Shape = S>, Momentum: State<Shape = M>> + Send + Sync + 'static,
    S: Send + Sync,
    M: Send + Sync,
{
    fn start(&self, mu: &AnyState) -> Result<AnyState, LiftError> {
        let mut typed = I::Momentum::zeros_of(&self.shapes.1);
        typed.set_coordinates(|i| mu.coordinate(i));
        Ok(AnyState::of(&self.integrator.start(&typed)?))
    }

    fn state_dimension(&self) -> usize {
        self.dimensions.0
    }

    fn tangent_dimension(&self) -> usize {
        self.dimensions.0.saturating_sub(self.clock)
    }

    fn states_are_momenta(&self) -> bool {
        self.tangent_dimension() == self.dimensions.1
    }
}
