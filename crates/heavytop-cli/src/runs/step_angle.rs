//! The largest angle by which a body may turn in one step.

use crate::Error;
use heavytop::HeavyTop;
use lie_poisson::Se3Dual;

/// The largest angle by which a body may turn in one step, rad: sixteen turns.
pub(crate) const MOST_TURN: f64 = 100.0;

/// Checks that the angle of a step, h (|Ω(0)| + √(m g l/I)) with I the least moment, is not too large.
pub(crate) fn require_sane_step(top: &HeavyTop, start: &Se3Dual, step: f64) -> Result<(), Error> {
    let spin = top.angular_velocity(&start.0.0).norm();
    let angle = step * (spin + (top.weight_moment() / top.inertia().min()).sqrt());
    if angle <= MOST_TURN || step <= 0.0 || step.is_nan() {
        Ok(())
    } else {
        Err(Error::AbsurdStep { step, angle, most: MOST_TURN })
    }
}
