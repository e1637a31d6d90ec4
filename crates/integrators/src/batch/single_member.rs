//! Advances one member of a batch by itself.

use crate::batch::checkpoint_blocks::blocks;
use crate::{IntegrationError, Integrator, StepError};
use core::ops::Range;
use lie_poisson::Real;

/// Advances one state from that after `steps.start` steps to that after `steps.end` steps.
///
/// The steps are those of a [`Trajectory`](crate::Trajectory) that starts there: nothing is remembered of earlier steps
/// at the start and at the multiples of [`CHECKPOINT`](crate::CHECKPOINT).
///
/// A [`LaneKernel`](crate::LaneKernel) calls it for a member whose SIMD lane has no result.
///
/// # Errors
/// Returns an [`IntegrationError`] with the number and the time of the failed step if the start or the step size is not
/// finite, or if a step fails. The state is then that before the step.
pub fn advance_alone<T: Real, I: Integrator<T>>(
    integrator: &I,
    state: &mut I::State,
    step: f64,
    steps: Range<u64>,
    workspace: &mut I::Workspace,
) -> Result<(), IntegrationError> {
    StepError::check_start(state, step)
        .map_err(|refused| IntegrationError::after(steps.start, step, refused))?;
    for block in blocks(steps) {
        integrator.forget(workspace);
        for made in block {
            let next = integrator.step(state, step, workspace);
            *state = next.map_err(|source| IntegrationError::after(made, step, source))?.point;
        }
    }
    Ok(())
}
