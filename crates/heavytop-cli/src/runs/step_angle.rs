//! The largest angle by which a body may turn in one step.

use crate::Error;
use heavytop::HeavyTop;
use lie_poisson::Se3Dual;

/// The largest angle by which a body may turn in one step, rad: sixteen turns.
pub(crate) const MOST_TURN: f64 = 100.0;

/// Returns the angle by which the body turns in a step, |h| (|Ω(0)| + √(m g l/I)) with I the least moment, rad.
fn angle(top: &HeavyTop, start: &Se3Dual, step: f64) -> f64 {
    let spin = top.angular_velocity(&start.0.0).norm();
    step.abs() * (spin + (top.weight_moment() / least_moment(top)).sqrt())
}

/// Returns the least moment of the top, kg m²: that across it for a thin rod.
pub(crate) fn least_moment(top: &HeavyTop) -> f64 {
    top.inertia().iter().copied().filter(|moment| *moment > 0.0).fold(f64::INFINITY, f64::min)
}

/// Checks that the body does not turn absurdly far in a step.
pub(crate) fn require_sane_step(top: &HeavyTop, start: &Se3Dual, step: f64) -> Result<(), Error> {
    let angle = angle(top, start, step);
    if angle <= MOST_TURN || step == 0.0 || step.is_nan() {
        Ok(())
    } else {
        Err(Error::AbsurdStep { step, angle, most: MOST_TURN })
    }
}
