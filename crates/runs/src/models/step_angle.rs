//! The largest angle by which a motion may turn in one step.

use super::model::Model;
use crate::error::RunFailure;
use heavytop::HeavyTop;
use heavytop::methods::Method;

/// The largest angle by which a motion may turn in one step, rad: sixteen turns.
const MOST_TURN: f64 = 100.0;

/// The angle by which a motion turns in a step that is chosen for it, rad. Gauss's method of order 8 then has a relative error of
/// the energy of some 1e-11.
pub const USUAL_TURN: f64 = 0.5;

/// The angle up to which a step is not too long, rad.
const GOOD_TURN: f64 = 1.0;

/// Returns a usual step, or a shorter one if a motion with this fastest rate (1/s) turns by more than 1 rad in it: a whole part of
/// the time to the end (s), in which it turns by half a radian at most.
#[must_use]
pub fn usual_step(usual: f64, end: f64, rate: f64) -> f64 {
    let steps = (end.abs() * rate / USUAL_TURN).ceil();
    match usual * rate > GOOD_TURN && steps.is_finite() && end != 0.0 {
        true => end.abs() / steps,
        false => usual,
    }
}

/// Returns an upper bound of the angular velocity of a top with this energy (J) and of the frequency of its swings: √(2(E + m g
/// l)/I) + √(m g l/I), I the least moment, 1/s.
#[must_use]
pub fn fastest_rate_of_top(top: &HeavyTop, energy: f64) -> f64 {
    let (weight, moment) = (top.weight_moment(), top.least_moment());
    let kinetic = (energy + weight).max(0.0);
    (2.0 * kinetic / moment).sqrt() + (weight / moment).sqrt()
}

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
