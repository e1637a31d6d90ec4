//! The largest angle by which a body may turn in one step.

use super::experiment::Experiment;
use crate::Error;
use heavytop::HeavyTop;
use lie_poisson::Se3Dual;

/// The largest angle by which a body may turn in one step, rad: sixteen turns.
pub(crate) const MOST_TURN: f64 = 100.0;

/// Returns the angle by which the body turns in a step, |h| (|Ω(0)| + √(m g l/I)) with I the least moment, rad.
fn angle(top: &HeavyTop, start: &Se3Dual, step: f64) -> f64 {
    let spin = top.angular_velocity(&start.0.0).norm();
    step.abs() * (spin + (top.weight_moment() / top.inertia().min()).sqrt())
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

/// Returns a warning if the body turns so far in a step that the motion may be wrong, however well the invariants hold.
///
/// The bounds, 1 rad up to order 2 and 3 rad up to order 4, are rules of thumb. The angle does not know whether the
/// method follows the rotation exactly, as a splitting of a symmetric top does, and methods of high order may be accurate
/// at far longer steps: nothing is said of them.
pub(crate) fn long_step(experiment: &Experiment) -> Option<String> {
    let Experiment { top, start, method, schedule, .. } = experiment;
    let (angle, scheme) = (angle(top, start, schedule.step), method.scheme());
    let most = match scheme.order() {
        ..3 => 1.0,
        3..5 => 3.0,
        _ => return None,
    };
    (angle > most).then(|| {
        let name = scheme.name();
        format!(
            "warning: the body turns by about {angle:.1} rad in a step, which may be too far for {name}; the \
             invariants do not show it: compare with a step of {:.1e} s or less",
            schedule.step.abs() * most / angle
        )
    })
}
