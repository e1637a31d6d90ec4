//! The largest angle by which a motion may turn in one step.

use super::model::Model;
use crate::error::RunFailure;
use heavytop::methods::Method;

/// The largest angle by which a motion may turn in one step, rad: sixteen turns.
const MOST_TURN: f64 = 100.0;

/// Checks that a motion does not turn absurdly far in a step from its start: the step times the
/// [fastest rate](collective_integrators::diagnostics::SystemScales::fastest_rate) there is at most 100 rad. Whether there
/// is a value at the start is for the run to say.
///
/// # Errors
/// If it turns farther.
pub fn require_sane_step(model: &dyn Model, start: &[f64], step: f64) -> Result<(), RunFailure> {
    let angle = step.abs() * model.fastest_rate(start);
    if angle.is_nan() { Ok(()) } else { require_turn(step, angle) }
}

/// Checks that there is an integrator of a method for runs from a start, and then that the motion does not turn absurdly far
/// in a step (s): [`require_sane_step`].
///
/// # Errors
/// If there is none, or the motion turns farther.
pub fn require_run(
    model: &dyn Model,
    method: &Method,
    (start, step): (&[f64], f64),
) -> Result<(), RunFailure> {
    model.integrator(method, start)?;
    require_sane_step(model, start, step)
}

/// Checks that an angle by which a motion turns in a step (s) is not absurd: it is at most 100 rad.
///
/// # Errors
/// If it is.
pub fn require_turn(step: f64, angle: f64) -> Result<(), RunFailure> {
    if angle <= MOST_TURN || step == 0.0 || step.is_nan() {
        Ok(())
    } else {
        Err(RunFailure::AbsurdStep { step, angle, most: MOST_TURN })
    }
}
