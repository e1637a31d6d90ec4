//! An integrator of any type: [`AnyIntegrator`].

use super::any_state::{AnyState, BlockEnds};
use super::any_steps::{AnyStart, AnySteps, AnyTangents, AnyWorkspace, Erased};
use crate::chaos::tangent_integrator::TangentIntegrator;
use crate::error::{IntegrationError, StepError};
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::schemes::scheme::Step;
use core::fmt;
use core::ops::Range;
use lie_poisson::{Real, State, Vector};
use momentum_map::LiftError;

/// An integrator whose type is known only when the program runs.
///
/// Everything that works with an [`Integrator`] works with it: trajectories, events, dense output, tangent vectors. It is then
/// compiled once, and not for each type of integrator. A step costs a call through a pointer and two copies of the state more,
/// and many steps in one call of [`advance`](Integrator::advance) cost that once.
///
/// The integrator is behind the object-safe trait `K`. [`AnyTangents`] has tangent maps, so that an
/// `AnyIntegrator<dyn AnyTangents>` is a [`TangentIntegrator`]; [`AnyStart`] has none.
///
/// # Example
/// A program that learns the order when it runs:
/// ```
/// use collective_integrators::{AnyIntegrator, AnyState, Direct, RungeKutta, Start, from_fn};
/// use nalgebra::Vector2;
/// let oscillator = || from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let method = |order: usize| match order {
///     4 => AnyIntegrator::new(Direct::new(RungeKutta::rk4(), oscillator()), 2),
///     _ => AnyIntegrator::new(Direct::new(RungeKutta::implicit_midpoint(), oscillator()), 2),
/// };
/// let error = |order| -> Result<f64, collective_integrators::RunError> {
///     let end = method(order).after(&AnyState::from_slice(&[1.0, 0.0]), 0.01, 100)?;
///     Ok((end.momentum.as_slice()[0] - 1.0_f64.cos()).abs())
/// };
/// assert!(error(4)? < 1e-10 && error(2)? > 1e-6);
/// # Ok::<(), collective_integrators::RunError>(())
/// ```
pub struct AnyIntegrator<K: ?Sized = dyn AnyStart>(Box<K>);

impl AnyIntegrator {
    /// Hides the type of an integrator. The first coordinates of its momenta, `dimension` of them, are those of the system;
    /// others, which complete the momenta to the width of their type, are zero and are left out.
    pub fn new<I>(integrator: I, dimension: usize) -> Self
    where
        I: Start<State: Vector, Momentum: Vector> + Send + Sync + 'static,
    {
        Self(Box::new(small(integrator, dimension)))
    }

    /// Hides the type of an integrator whose states are as large as `state`, and its momenta as large as `momentum`.
    ///
    /// # Example
    /// Point vortices, say, of which there are as many as a file lists:
    /// ```
    /// use collective_integrators::{AnyIntegrator, AnyState, Direct, Integrator, RungeKutta, Start, from_fn};
    /// use lie_poisson::{Sites, State};
    /// use nalgebra::Vector1;
    /// let decay = from_fn(|z: &Sites<Vector1<f64>>| z.iter().map(|z| -z).collect::<Sites<_>>());
    /// let sites = Sites::new(vec![Vector1::new(0.0); 50]);
    /// let rk4 = AnyIntegrator::of_states(Direct::new(RungeKutta::rk4(), decay), &sites, &sites);
    /// let end = rk4.after(&AnyState::from_slice(&[1.0; 50]), 0.01, 100)?.momentum;
    /// assert!(end.as_slice().iter().all(|z| (z - (-1.0_f64).exp()).abs() < 1e-10));
    /// # Ok::<(), collective_integrators::RunError>(())
    /// ```
    pub fn of_states<I>(integrator: I, state: &I::State, momentum: &I::Momentum) -> Self
    where
        I: Start<Momentum: State> + Send + Sync + 'static,
    {
        Self(Box::new(erased(integrator, (state, 0), (momentum, momentum.dimension()))))
    }
}

impl AnyIntegrator<dyn AnyTangents> {
    /// Hides the type of an integrator that has tangent maps, as [`of_states`](AnyIntegrator::of_states) does.
    pub fn of_states_with_tangents<I>(
        integrator: I,
        state: &StateOf<I>,
        momentum: &MomentumOf<I>,
    ) -> Self
    where
        I: Start<Momentum: State> + TangentIntegrator + Send + Sync + 'static,
    {
        Self::of_clocked_states(integrator, (state, 0), momentum)
    }

    /// Hides the type of an integrator that has tangent maps and whose states end with the coordinates of a clock, so many of them:
    /// the time, say, and the number of a path. Tangent vectors compare motions at the same time, and have zeros there.
    ///
    /// # Example
    /// The number x of dx/dt = −x + t, beside the time:
    /// ```
    /// use collective_integrators::{AnyIntegrator, AnyState, Direct, RungeKutta, Start, TangentFrame, VectorField};
    /// use lie_poisson::Real;
    /// use nalgebra::{Vector1, Vector2};
    /// struct Driven;
    /// impl<T: Real> VectorField<T> for Driven {
    ///     type Point = Vector2<T>;
    ///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
    ///         Vector2::new(z.y - z.x, T::one())
    ///     }
    /// }
    /// let rk4 = Direct::new(RungeKutta::rk4(), Driven);
    /// let zero = Vector2::zeros();
    /// let driven = AnyIntegrator::of_clocked_states(rk4, (&zero, 1), &zero);
    /// assert_eq!((driven.state_dimension(), driven.tangent_dimension()), (2, 1));
    /// let start = driven.start(&AnyState::from_slice(&[3.0, 0.0]))?;
    /// let mut frame = TangentFrame::generic(&driven, start, (1, driven.tangent_dimension()), 0.01);
    /// frame.normalise()?;
    /// for _ in 0..100 {
    ///     frame.advance()?;
    /// }
    /// assert!((frame.normalise()?[0] - (-1.0_f64).exp()).abs() < 1e-10);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_clocked_states<I>(
        integrator: I,
        (state, clock): (&StateOf<I>, usize),
        momentum: &MomentumOf<I>,
    ) -> Self
    where
        I: Start<Momentum: State> + TangentIntegrator + Send + Sync + 'static,
    {
        Self(Box::new(erased(integrator, (state, clock), (momentum, momentum.dimension()))))
    }

    /// Hides the type of an integrator that has tangent maps, as [`new`](AnyIntegrator::new) does.
    pub fn with_tangents<I>(integrator: I, dimension: usize) -> Self
    where
        I: Start<State: Vector, Momentum: Vector> + TangentIntegrator + Send + Sync + 'static,
    {
        Self(Box::new(small(integrator, dimension)))
    }

    /// Hides the tangent maps, too.
    #[must_use]
    pub fn without_tangents(self) -> AnyIntegrator {
        AnyIntegrator(self.0)
    }
}

impl<K: ?Sized + AnyStart> AnyIntegrator<K> {
    /// Returns the dimension of the states.
    #[must_use]
    pub fn state_dimension(&self) -> usize {
        self.0.state_dimension()
    }

    /// Returns the number of coordinates of the states along which there are tangent vectors: all but those of a
    /// [clock](AnyIntegrator::of_clocked_states).
    #[must_use]
    pub fn tangent_dimension(&self) -> usize {
        self.0.tangent_dimension()
    }

    /// Returns whether the states are momenta, with or without a clock, so that its tangent vectors are those of momenta.
    #[must_use]
    pub fn states_are_momenta(&self) -> bool {
        self.0.states_are_momenta()
    }
}

/// An integrator with the spaces of its states and momenta.
type ErasedOf<I> = Erased<I, ShapeOf<StateOf<I>>, ShapeOf<MomentumOf<I>>>;

type StateOf<I> = <I as Integrator>::State;
type MomentumOf<I> = <I as Integrator>::Momentum;
type ShapeOf<V> = <V as State>::Shape;

fn small<I: Start<State: Vector, Momentum: Vector>>(
    integrator: I,
    dimension: usize,
) -> ErasedOf<I> {
    let (state, momentum) = (Vector::from_coordinates(|_| 0.0), Vector::from_coordinates(|_| 0.0));
    erased(integrator, (&state, 0), (&momentum, dimension))
}

/// Hides the type of an integrator on states, with so many coordinates of a clock, and momenta as large as these. The first
/// coordinates of the momenta, `dimension` of them, are those of the system.
fn erased<I: Start<Momentum: State>>(
    integrator: I,
    (state, clock): (&StateOf<I>, usize),
    (momentum, dimension): (&MomentumOf<I>, usize),
) -> ErasedOf<I> {
    let shapes = (state.shape(), momentum.shape());
    let dimensions = (state.dimension(), momentum.dimension());
    Erased { integrator, shapes, dimensions, clock, momenta: BlockEnds::of(momentum, dimension) }
}

impl<K: ?Sized> fmt::Debug for AnyIntegrator<K> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("AnyIntegrator")
    }
}

impl<K: ?Sized + AnySteps<T>, T: Real> Integrator<T> for AnyIntegrator<K> {
    type State = AnyState<T>;
    type Momentum = AnyState<T>;
    type Workspace = AnyWorkspace;

    fn workspace(&self) -> AnyWorkspace {
        self.0.workspace()
    }

    fn step(
        &self,
        state: &AnyState<T>,
        step: f64,
        workspace: &mut AnyWorkspace,
    ) -> Result<Step<AnyState<T>>, StepError> {
        let mut point = state.clone();
        let iterations = self.0.step_in_place(&mut point, step, workspace)?;
        Ok(Step { point, iterations })
    }

    fn step_in_place(
        &self,
        state: &mut AnyState<T>,
        step: f64,
        workspace: &mut AnyWorkspace,
    ) -> Result<usize, StepError> {
        self.0.step_in_place(state, step, workspace)
    }

    fn advance(
        &self,
        state: &mut AnyState<T>,
        step: f64,
        steps: Range<u64>,
        workspace: &mut AnyWorkspace,
    ) -> Result<usize, IntegrationError> {
        self.0.advance(state, step, steps, workspace)
    }

    fn forget(&self, workspace: &mut AnyWorkspace) {
        self.0.forget(workspace);
    }

    fn pin(&self, workspace: &mut AnyWorkspace) {
        self.0.pin(workspace);
    }

    fn momentum(&self, state: &AnyState<T>) -> AnyState<T> {
        self.0.momentum(state)
    }
}

impl<K: ?Sized + AnyStart> Start for AnyIntegrator<K> {
    fn start(&self, mu: &AnyState) -> Result<AnyState, LiftError> {
        self.0.start(mu)
    }
}
