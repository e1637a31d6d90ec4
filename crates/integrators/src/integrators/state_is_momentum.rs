//! Integrators whose state is the momentum: [`StateIsMomentum`].

use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use lie_poisson::Real;
use momentum_map::LiftError;

/// An [`Integrator`] whose state is μ itself, or a point of another space than 𝔤∗. It can [`Start`] from every such
/// point.
///
/// # Example
/// The implicit Euler method for ż = −z:
/// ```
/// use collective_integrators::{Integrator, Start, StateIsMomentum, Step, StepError};
/// use nalgebra::Vector1;
/// struct Decay;
/// impl Integrator for Decay {
///     type State = Vector1<f64>;
///     type Momentum = Vector1<f64>;
///     type Workspace = ();
///     fn workspace(&self) {}
///     fn step(
///         &self,
///         z: &Vector1<f64>,
///         h: f64,
///         (): &mut (),
///     ) -> Result<Step<Vector1<f64>>, StepError> {
///         Step { point: z / (1.0 + h), iterations: 0 }.finite()
///     }
///     // It remembers nothing.
///     fn forget(&self, (): &mut ()) {}
///     fn momentum(&self, z: &Vector1<f64>) -> Vector1<f64> {
///         *z
///     }
/// }
/// impl StateIsMomentum for Decay {}
/// assert_eq!(Decay.after(&Vector1::new(1.0), 1.0, 3)?.state.x, 0.125);
/// # Ok::<(), collective_integrators::RunError>(())
/// ```
pub trait StateIsMomentum {}

impl<I, T> Start<T> for I
where
    I: StateIsMomentum + Integrator<T, Momentum = <I as Integrator<T>>::State>,
    T: Real,
{
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError> {
        Ok(mu.clone())
    }
}
