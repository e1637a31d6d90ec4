//! How far a body may turn in one step.

use crate::Error;
use heavytop::HeavyTop;
use lie_poisson::Se3Dual;

/// The most that a body may turn in one step, rad: sixteen times around.
pub(crate) const MOST_TURN: f64 = 100.0;

/// Checks that h (|Ω(0)| + √(m g l/I)), I the least moment, is an angle that a step may have.
pub(crate) fn require_sane_step(top: &HeavyTop, start: &Se3Dual, step: f64) -> Result<(), Error> {
    let spin = top.angular_velocity(&start.0.0).norm();
    let angle = step * (spin + (top.weight_moment() / top.inertia().min()).sqrt());
    if angle <= MOST_TURN || step <= 0.0 || step.is_nan() {
        Ok(())
    } else {
        Err(Error::AbsurdStep { step, angle, most: MOST_TURN })
    }
}
