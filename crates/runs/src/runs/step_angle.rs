//! The largest angle by which a motion may turn in one step.

use crate::RunFailure;
use heavytop::HeavyTop;
use lie_poisson::Se3Dual;
use lie_poisson_formula_systems::{FormulaSystem, SystemMethod};

/// The largest angle by which a motion may turn in one step, rad: sixteen turns.
const MOST_TURN: f64 = 100.0;

/// Returns the angle by which the body turns in a step, |h| (|Ω(0)| + √(m g l/I)) with I the least moment, rad.
fn angle(top: &HeavyTop, start: &Se3Dual, step: f64) -> f64 {
    let spin = top.angular_velocity(&start.0.0).norm();
    step.abs() * (spin + (top.weight_moment() / least_moment(top)).sqrt())
}

/// Returns the least moment of the top, kg m²: that across it for a thin rod.
#[must_use]
pub fn least_moment(top: &HeavyTop) -> f64 {
    top.inertia().iter().copied().filter(|moment| *moment > 0.0).fold(f64::INFINITY, f64::min)
}

/// Checks that the body does not turn absurdly far in a step (s) from its start: |h| (|Ω(0)| + √(m g l/I)), with the least
/// moment I, is at most 100 rad.
///
/// # Errors
/// If it turns farther.
pub fn require_sane_step(top: &HeavyTop, start: &Se3Dual, step: f64) -> Result<(), RunFailure> {
    require_turn(step, angle(top, start, step))
}

/// Checks that the motion of a system does not turn absurdly far in a step from its start: the step times the spectral radius
/// of the derivative of its equations there is at most 100 rad. Whether there is a value at the start is for the run to say.
///
/// # Errors
/// If it turns farther, or there is no such method.
pub fn require_sane_step_of_system(
    method: &SystemMethod,
    system: &FormulaSystem,
    start: &[f64],
    step: f64,
) -> Result<(), RunFailure> {
    // A run without steps has the angle at its start.
    let angle = method.accuracy(system, start, (step, 0), &|| true)?.angle;
    if angle.is_nan() { Ok(()) } else { require_turn(step, angle) }
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
