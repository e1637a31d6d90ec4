//! Tasks that work with every type of integrator.

use crate::Turning;
use collective_integrators::{Start, TangentIntegrator};
use lie_poisson::{Se3Dual, Vector};

/// A task to perform with an integrator of a heavy top, whatever its type.
///
/// The state of the integrator is that of its formulation: a spinor χ and its momentum ψ for a collective one, and
/// (Π, Γ) for the others. Its momentum is (Π, Γ) for all of them. [The module](super) has an example.
pub trait Task {
    /// The result of the task.
    type Output;

    /// Performs the task with an integrator.
    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(self, integrator: &I) -> Self::Output;

    /// Performs the task with an integrator that can carry the attitude along; by default without the attitude.
    fn perform_turning<I: Turning + Start>(self, integrator: I) -> Self::Output
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
    fn perform<I>(self, integrator: &I) -> Self::Output
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator;

    /// Performs the task with an integrator that can carry the attitude along; by default without the attitude.
    fn perform_turning<I>(self, integrator: I) -> Self::Output
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

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(self, integrator: &I) -> K::Output {
        self.0.perform(integrator)
    }

    fn perform_turning<I: Turning + Start>(self, integrator: I) -> K::Output {
        self.0.perform_turning(integrator)
    }
}
