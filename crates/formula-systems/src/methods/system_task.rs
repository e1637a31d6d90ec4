//! A task that works with every type of integrator of a system: [`SystemTask`].

use collective_integrators::{Start, TangentIntegrator};
use lie_poisson::Vector;

/// A task to perform with an integrator of a system, whatever its type.
///
/// The first coordinates of a momentum, as many as the algebra has dimensions, are those of the algebra; further
/// coordinates, which are zero, may follow: they complete a direct integrator to a width for which it is compiled. The
/// state of the integrator is that of its formulation: a momentum for a direct or a reduced one, and a point of the
/// lifted space for a collective one. The integrator has tangent maps for tasks that need them.
///
/// [`SystemMethod::integrate`](crate::SystemMethod::integrate) has an example.
pub trait SystemTask {
    /// The result of the task.
    type Output;

    /// Performs the task with an integrator.
    fn perform<I>(self, integrator: &I) -> Self::Output
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>> + TangentIntegrator;
}
