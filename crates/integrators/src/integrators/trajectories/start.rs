//! Trajectories from momenta: [`Start`].

use super::integrator::{Integrator, SampleOf, Trajectory};
use crate::error::{IntegrationError, RunError, StepError};
use lie_poisson::Real;
use momentum_map::LiftError;

/// An integrator that can start from a momentum.
#[diagnostic::on_unimplemented(
    message = "the integrator `{Self}` cannot start from a momentum over `{T}`",
    label = "no state is known for a momentum",
    note = "start from a state with `trajectory_from`; for a point z of phase space its momentum is M(z)",
    note = "or implement `momentum_map::Lift` for the Poisson map, which chooses z with M(z) = μ"
)]
pub trait Start<T: Real = f64>: Integrator<T> {
    /// Returns a state that represents μ.
    ///
    /// # Errors
    /// Returns a [`LiftError`] if no state represents μ.
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError>;

    /// Creates the trajectory through μ at t = 0, with steps of size `step`.
    ///
    /// The momentum of the first sample is μ itself, bit for bit. That of its state, such as M(z) of a lift z, equals μ
    /// only up to rounding.
    ///
    /// # Errors
    /// Returns [`RunError::Integration`] for the first step if a coordinate of μ or the step size is not finite
    /// ([`StepError::NotFiniteStart`], [`StepError::StepSize`]), or [`RunError::Lift`] if no state represents μ.
    fn trajectory(
        &self,
        mu: &Self::Momentum,
        step: f64,
    ) -> Result<Trajectory<'_, Self, T>, RunError>
    where
        Self: Sized,
    {
        StepError::check_start(mu, step)
            .map_err(|refused| IntegrationError::after(0, step, refused))?;
        Ok(self.trajectory_from(self.start(mu)?, step).through(mu.clone()))
    }

    /// Returns the sample after `steps` steps of size `step` from μ at t = 0.
    ///
    /// No earlier sample is stored. After 0 steps the result is the sample of the start.
    ///
    /// # Errors
    /// Returns the errors of [`trajectory`](Self::trajectory), and [`RunError::Integration`] with the number, the time
    /// and the reason if a step fails.
    ///
    /// # Example
    /// The pendulum returns after its period 4K(sin²(θ/2)), 6.699975664370453 for θ = 1 (DLMF §22.19(i)):
    /// ```
    /// use collective_integrators::{Direct, RungeKutta, Start, from_fn};
    /// use nalgebra::Vector2;
    /// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
    /// let gauss = Direct::new(RungeKutta::gauss(5)?, pendulum);
    /// let (start, steps) = (Vector2::new(1.0, 0.0), 100);
    /// let last = gauss.after(&start, 6.699975664370453 / steps as f64, steps)?;
    /// assert_eq!(last.step, steps);
    /// assert!((last.state - start).norm() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn after(
        &self,
        mu: &Self::Momentum,
        step: f64,
        steps: u64,
    ) -> Result<SampleOf<Self, T>, RunError>
    where
        Self: Sized,
    {
        Ok(self.trajectory(mu, step)?.after(steps)?)
    }
}
