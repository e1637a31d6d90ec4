//! States between the samples of a trajectory.

use crate::{IntegrationError, Integrator, Sample, SampleOf};
use core::fmt;

/// The state a time τ after a sample: one step of the size τ from it.
///
/// Its error is that of one step of the integrator, for any τ up to the step size; it keeps what
/// every step keeps (Casimirs, with a collective integrator), as no polynomial between samples
/// would.
pub(crate) struct PartialStep<'a, I: Integrator> {
    integrator: &'a I,
    workspace: I::Workspace,
}

impl<'a, I: Integrator> PartialStep<'a, I> {
    pub(crate) fn new(integrator: &'a I) -> Self {
        Self { integrator, workspace: integrator.workspace() }
    }

    /// The sample after `from`, with the number of the latter.
    pub(crate) fn after(
        &mut self,
        from: &SampleOf<I>,
        tau: f64,
    ) -> Result<SampleOf<I>, IntegrationError> {
        let Sample { step, time, .. } = *from;
        match self.integrator.step(&from.state, tau, &mut self.workspace) {
            Ok(next) => Ok(Sample {
                step,
                time: time + tau,
                state: next.point,
                momentum: self.integrator.momentum(&next.point),
                iterations: next.iterations,
            }),
            Err(source) => Err(IntegrationError { step: step.saturating_add(1), time, source }),
        }
    }
}

/// Without the workspace, whose contents mean nothing between steps.
impl<I: Integrator + fmt::Debug> fmt::Debug for PartialStep<'_, I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("PartialStep").field(&self.integrator).finish()
    }
}
