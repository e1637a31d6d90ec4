//! Computing times and errors.

use super::problem::{EARLY, Problem};
use crate::Error;
use lie_poisson::{Covector, Pair, Se3Dual};
use serde::Serialize;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// A run is repeated so often, if it does not take long,
const REPEATS: u32 = 5;

/// at least so long,
const LEAST: Duration = Duration::from_millis(300);

/// and, twice or more, no longer than this.
const MOST: Duration = Duration::from_secs(4);

/// What came of an integrator with one step.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Run {
    /// The integrator.
    pub name: String,
    /// Its step, as `h = 0.25`; s.
    pub setting: String,
    /// The number of tops.
    pub tops: u64,
    /// The least computing time of a run from 0 to the end, all tops together, s.
    pub seconds: f64,
    /// Steps of each top in that time.
    pub steps: u64,
    /// The 2-norm of the error of (Π, Γ) at t = 10 s, the mean over tops.
    pub error_10: f64,
    /// The end, s.
    pub end: f64,
    /// The same error there.
    pub error_end: f64,
}

/// Times an integrator: `run(steps)` gives the states of the tops that have references after so many
/// steps of `step` s.
///
/// # Errors
/// If a run fails.
pub(super) fn measure(
    name: &str,
    step: f64,
    problem: &Problem,
    mut run: impl FnMut(u64) -> Result<Vec<Se3Dual>, Error>,
) -> Result<Run, Error> {
    let steps = |time: f64| (time / step).round() as u64;
    let error_10 = mean_error(&run(steps(EARLY))?, &problem.early);
    let error_end = mean_error(&run(steps(problem.end))?, &problem.late);
    let (begin, mut least, mut repeats) = (Instant::now(), Duration::MAX, 0);
    while repeats < 2 || begin.elapsed() < LEAST || (repeats < REPEATS && begin.elapsed() < MOST) {
        let started = Instant::now();
        black_box(run(black_box(steps(problem.end)))?);
        least = least.min(started.elapsed());
        repeats += 1;
    }
    Ok(Run {
        name: name.to_owned(),
        setting: format!("h = {step}"),
        tops: problem.tops,
        seconds: least.as_secs_f64(),
        steps: steps(problem.end),
        error_10,
        end: problem.end,
        error_end,
    })
}

fn mean_error(states: &[Se3Dual], reference: &[Se3Dual]) -> f64 {
    let norm = |Covector(Pair(pi, gamma)): Se3Dual| pi.norm().hypot(gamma.norm());
    let sum: f64 = states.iter().zip(reference).map(|(mu, exact)| norm(*mu - *exact)).sum();
    sum / reference.len() as f64
}
