//! Steps of partial size between the samples of a trajectory.

use crate::error::IntegrationError;
use crate::integrators::trajectories::integrator::{Integrator, SampleOf};
use crate::integrators::trajectories::sample::Sample;
use crate::schemes::scheme::Step;
use core::fmt;

/// A step of partial size τ from a sample, which gives the state a time τ after it.
///
/// The error is that of one step of the integrator, for any τ up to the step size. The step keeps what every step
/// keeps, such as the Casimirs of a collective integrator. A polynomial between samples would not.
///
/// The state is not moved along its fibre ([`Integrator::pin`]). All steps from a sample therefore begin at one point, also
/// where the image of a step depends on the point of the fibre.
pub(crate) struct PartialStep<'a, I: Integrator> {
    integrator: &'a I,
    workspace: I::Workspace,
}

impl<'a, I: Integrator> PartialStep<'a, I> {
    pub(crate) fn new(integrator: &'a I) -> Self {
        let mut workspace = integrator.workspace();
        integrator.pin(&mut workspace);
        Self { integrator, workspace }
    }

    /// Returns the sample at time τ after `from`, with the step number of `from`.
    pub(crate) fn after(
        &mut self,
        from: &SampleOf<I>,
        tau: f64,
    ) -> Result<SampleOf<I>, IntegrationError> {
        let Sample { step, time, .. } = *from;
        match self.integrator.step(&from.state, tau, &mut self.workspace) {
            Ok(Step { point: state, iterations }) => {
                let momentum = self.integrator.momentum(&state);
                Ok(Sample { step, time: time + tau, state, momentum, iterations })
            }
            Err(source) => Err(IntegrationError { step: step.saturating_add(1), time, source }),
        }
    }
}

/// Formats the integrator without the workspace, whose contents have no meaning between steps.
impl<I: Integrator + fmt::Debug> fmt::Debug for PartialStep<'_, I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("PartialStep").field(&self.integrator).finish()
    }
}
