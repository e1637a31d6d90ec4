//! Tasks that work with every type of integrator.

use crate::Error;
use collective_integrators::{Start, TangentIntegrator};
use heavytop::Turning;
use lie_poisson::{Se3Dual, Vector};

/// A task to perform with an integrator of the heavy top, whatever its type.
pub trait Task {
    /// The result of the task.
    type Output;

    /// Performs the task with an integrator.
    ///
    /// # Errors
    /// If the task fails.
    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(
        self,
        integrator: &I,
    ) -> Result<Self::Output, Error>;

    /// Performs the task with an integrator that can carry the attitude along; by default without the attitude.
    ///
    /// # Errors
    /// If the task fails.
    fn perform_turning<I: Turning + Start>(self, integrator: I) -> Result<Self::Output, Error>
    where
        Self: Sized,
    {
        self.perform(&integrator)
    }
}

/// A task to perform with an integrator that has tangent maps, by dual numbers.
pub trait TangentTask {
    /// The result of the task.
    type Output;

    /// Performs the task with an integrator.
    ///
    /// # Errors
    /// If the task fails.
    fn perform<I>(self, integrator: &I) -> Result<Self::Output, Error>
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator;

    /// Performs the task with an integrator that can carry the attitude along; by default without the attitude.
    ///
    /// # Errors
    /// If the task fails.
    fn perform_turning<I>(self, integrator: I) -> Result<Self::Output, Error>
    where
        I: Turning + Start + TangentIntegrator,
        Self: Sized,
    {
        self.perform(&integrator)
    }
}

/// A task that does not need tangent maps.
pub(super) struct Plain<K>(pub(super) K);

impl<K: Task> TangentTask for Plain<K> {
    type Output = K::Output;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(
        self,
        integrator: &I,
    ) -> Result<K::Output, Error> {
        self.0.perform(integrator)
    }

    fn perform_turning<I: Turning + Start>(self, integrator: I) -> Result<K::Output, Error> {
        self.0.perform_turning(integrator)
    }
}
