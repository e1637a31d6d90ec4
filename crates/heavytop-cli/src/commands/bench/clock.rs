//! The measurement of computing times and errors.

use super::problem::{BenchProblem, EARLY};
use crate::Error;
use lie_poisson::{Covector, Pair, Se3Dual};
use serde::Serialize;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The number of repetitions of a run, unless they take longer than [`MOST`].
const REPEATS: u32 = 5;

/// The least total time of the repetitions of a run.
const LEAST: Duration = Duration::from_millis(300);

/// The total time after which a run is not repeated again, once it was repeated twice.
const MOST: Duration = Duration::from_secs(4);

/// The computing time and the error of an integrator with one step size.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Run {
    /// The name of the integrator.
    pub name: String,
    /// The step size, as `h = 0.25`; s.
    pub setting: String,
    /// The number of tops.
    pub tops: u64,
    /// The least computing time of a run from 0 to the end, all tops together, s.
    pub seconds: f64,
    /// The number of steps of each top in that time.
    pub steps: u64,
    /// The 2-norm of the error of (Π, Γ) at t = 10 s, the mean over tops.
    pub error_10: f64,
    /// The end of the run, s.
    pub end: f64,
    /// The 2-norm of the error of (Π, Γ) at the end, the mean over tops.
    pub error_end: f64,
}

/// Times an integrator and measures its errors.
///
/// `run(steps)` makes so many steps of `step` s, and returns the states of those tops that have references.
///
/// # Errors
/// If a run fails.
pub(super) fn measure(
    name: &str,
    step: f64,
    problem: &BenchProblem,
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
