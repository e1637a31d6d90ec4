//! Integrators that carry tangent vectors along: [`TangentIntegrator`], [`VariationalError`].

use crate::error::IntegrationError;
use crate::integrators::trajectories::integrator::Integrator;
use lie_poisson::{DualNumber, State};
use thiserror::Error;

/// The type of the states of `I`.
pub(super) type StateOf<I> = <I as Integrator>::State;

/// The type of the states of `I` over dual numbers.
pub(super) type DualStateOf<I> = <I as Integrator<DualNumber>>::State;

/// The type of the momenta of `I`.
pub(super) type MomentumOf<I> = <I as Integrator>::Momentum;

/// An integrator over `f64` and over dual numbers, whose steps carry tangent vectors along.
///
/// It is implemented for every integrator over both scalars whose states over both have the same
/// [`Shape`](State::Shape).
pub trait TangentIntegrator:
    Integrator + Integrator<DualNumber, State: State<Shape = <StateOf<Self> as State>::Shape>>
{
}

impl<I> TangentIntegrator for I where
    I: Integrator + Integrator<DualNumber, State: State<Shape = <StateOf<I> as State>::Shape>>
{
}

/// The reason why tangent vectors cannot be advanced.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum VariationalError {
    /// The run failed, for the state or for a tangent vector.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// A tangent vector lies in the span of the preceding vectors, to round-off, or is not finite.
    #[error(
        "tangent vector {index} has the length {length:e} beyond those before it, at t = {time}"
    )]
    Dependent {
        /// The index of the vector; the first is 0.
        index: usize,
        /// The length of the component of the vector orthogonal to the preceding vectors.
        length: f64,
        /// The time of the failure.
        time: f64,
    },
    /// The elapsed time is zero or overflows, or is so small that numbers per unit of time overflow.
    #[error("there are no exponents per unit of time after {steps} steps of size {step:e}")]
    StepSize {
        /// The number of steps made.
        steps: u64,
        /// The step size of the run.
        step: f64,
    },
}
