//! Integrators on 𝔤∗: what is advanced, and how μ is read off it.

use crate::{IntegrationError, RunError, SampleOf, Step, StepError, Trajectory};
use lie_poisson::{Real, Vector};
use momentum_map::LiftError;

/// A method that advances a state and reads a momentum μ off it.
///
/// # Example
/// See [`Collective`](crate::Collective).
pub trait Integrator<T: Real = f64> {
    /// What is advanced: z ∈ P, or μ itself.
    type State: Vector<Scalar = T>;

    /// What is simulated: μ ∈ 𝔤∗.
    type Momentum: Vector<Scalar = T>;

    /// The storage of a step.
    type Workspace;

    /// Allocates the storage of a step.
    fn workspace(&self) -> Self::Workspace;

    /// One step of size `step`, which may be negative.
    ///
    /// # Errors
    /// If the step has no result; see [`Scheme::step`](crate::Scheme::step).
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError>;

    /// Drops what the workspace remembers of the steps before: the next one depends on its starting
    /// point alone, to the last bit. By default nothing, for methods that remember nothing.
    #[inline]
    fn forget(&self, _workspace: &mut Self::Workspace) {}

    /// μ of a state.
    fn momentum(&self, state: &Self::State) -> Self::Momentum;

    /// The trajectory through a state at t = 0, with steps of size `step`. If a coordinate of the state or
    /// the step size is not finite, its first item is the error.
    fn trajectory_from(&self, state: Self::State, step: f64) -> Trajectory<'_, Self, T>
    where
        Self: Sized,
    {
        Trajectory::new(self, state, 0, step)
    }

    /// The trajectory that has made `made` steps of size `step` and come to a state: what goes on
    /// from a sample of another run, with its numbers and times. It fails as
    /// [`trajectory_from`](Self::trajectory_from) does, and after the step with the number
    /// [`u64::MAX`].
    ///
    /// If `made` is a multiple of [`CHECKPOINT`](crate::CHECKPOINT), it equals the run that was not
    /// interrupted to the last bit.
    fn trajectory_resumed(
        &self,
        state: Self::State,
        made: u64,
        step: f64,
    ) -> Trajectory<'_, Self, T>
    where
        Self: Sized,
    {
        Trajectory::new(self, state, made, step)
    }
}

/// An integrator that can start from a momentum.
pub trait Start<T: Real = f64>: Integrator<T> {
    /// The state that represents μ.
    ///
    /// # Errors
    /// If there is none.
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError>;

    /// The trajectory through μ at t = 0, with steps of size `step`.
    ///
    /// # Errors
    /// If a coordinate of μ or the step size is not finite ([`StepError::NotFiniteStart`],
    /// [`StepError::StepSize`], both of the first step), or if no state represents μ.
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
        Ok(self.trajectory_from(self.start(mu)?, step))
    }

    /// The sample after `steps` steps of size `step` from μ at t = 0, which stores none of those
    /// before it; after 0 steps, that of the start.
    ///
    /// # Errors
    /// As for [`trajectory`](Self::trajectory), and if a step fails, with its number, its time and the
    /// reason.
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
    /// assert!((last.momentum - start).norm() < 1e-12);
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
