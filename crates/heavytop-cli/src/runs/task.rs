//! Something to do with an integrator, whichever type it has.

use crate::Error;
use collective_integrators::{Integrator, Start};
use heavytop::Turning;
use lie_poisson::{DualNumber, Se3Dual};

/// Something to do with an integrator of the heavy top, whichever type it has.
pub trait Task {
    /// What comes of it.
    type Output;

    /// Does it.
    ///
    /// # Errors
    /// If it fails.
    fn perform<I: Start<Momentum = Se3Dual>>(self, integrator: &I) -> Result<Self::Output, Error>;

    /// Does it with an integrator that can carry the attitude along. By default without the attitude.
    ///
    /// # Errors
    /// If it fails.
    fn perform_turning<I: Turning + Start>(self, integrator: I) -> Result<Self::Output, Error>
    where
        Self: Sized,
    {
        self.perform(&integrator)
    }
}

/// Something to do with an integrator that has tangent maps, by dual numbers.
pub trait TangentTask {
    /// What comes of it.
    type Output;

    /// Does it.
    ///
    /// # Errors
    /// If it fails.
    fn perform<I>(self, integrator: &I) -> Result<Self::Output, Error>
    where
        I: Start<Momentum = Se3Dual> + Integrator<DualNumber>;

    /// Does it with an integrator that can carry the attitude along. By default without the attitude.
    ///
    /// # Errors
    /// If it fails.
    fn perform_turning<I>(self, integrator: I) -> Result<Self::Output, Error>
    where
        I: Turning + Start + Integrator<DualNumber>,
        Self: Sized,
    {
        self.perform(&integrator)
    }
}

/// A task that has no use for tangent maps.
pub(super) struct Plain<K>(pub(super) K);

impl<K: Task> TangentTask for Plain<K> {
    type Output = K::Output;

    fn perform<I: Start<Momentum = Se3Dual>>(self, integrator: &I) -> Result<K::Output, Error> {
        self.0.perform(integrator)
    }

    fn perform_turning<I: Turning + Start>(self, integrator: I) -> Result<K::Output, Error> {
        self.0.perform_turning(integrator)
    }
}
