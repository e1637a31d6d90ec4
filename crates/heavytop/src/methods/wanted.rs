//! What a method makes of the integrator of a top, whatever its type.

use crate::attitude::step_rotation::Turning;
use crate::attitude::with_attitude::WithAttitude;
use collective_integrators::{AnyIntegrator, AnyTangents, Start, TangentIntegrator};
use lie_poisson::{Se3Dual, Vector};

/// The dimension of (Π, Γ).
pub(super) const DIMENSION: usize = 6;

/// An integrator that is wanted: with tangent maps, or with the attitude.
pub(super) trait Wanted {
    /// The integrator that is made.
    type Made;

    /// Makes it of an integrator that does not know the attitude.
    fn of<I>(integrator: I) -> Self::Made
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator + Send + Sync + 'static;

    /// Makes it of an integrator that can carry the attitude along.
    fn of_turning<I>(integrator: I) -> Self::Made
    where
        I: Turning + Start + TangentIntegrator + Send + Sync + 'static;
}

/// An integrator with tangent maps.
pub(super) struct Tangents;

impl Wanted for Tangents {
    type Made = AnyIntegrator<dyn AnyTangents>;

    fn of<I>(integrator: I) -> Self::Made
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator + Send + Sync + 'static,
    {
        AnyIntegrator::with_tangents(integrator, DIMENSION)
    }

    fn of_turning<I>(integrator: I) -> Self::Made
    where
        I: Turning + Start + TangentIntegrator + Send + Sync + 'static,
    {
        AnyIntegrator::with_tangents(integrator, DIMENSION)
    }
}

/// An integrator that carries the attitude along, if there is one.
pub(super) struct Attitude;

impl Wanted for Attitude {
    type Made = Option<AnyIntegrator>;

    fn of<I>(_: I) -> Self::Made
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator + Send + Sync + 'static,
    {
        None
    }

    fn of_turning<I>(integrator: I) -> Self::Made
    where
        I: Turning + Start + TangentIntegrator + Send + Sync + 'static,
    {
        Some(with_attitude(integrator))
    }
}

/// Makes an integrator carry the attitude along.
pub(super) fn with_attitude<I>(integrator: I) -> AnyIntegrator
where
    I: Turning + Start + Send + Sync + 'static,
{
    AnyIntegrator::new(WithAttitude(integrator), DIMENSION)
}
