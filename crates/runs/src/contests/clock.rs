//! The measurement of computing times and errors.

use super::problem::{EARLY, TimedProblem};
use crate::error::RunFailure;
use lie_poisson::{BlockScales, Covector, Pair, Se3Dual};
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
pub struct TimedRun {
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
    /// The 2-norm of the error of (Π, Γ) at t = 10 s in SI units, the mean over tops. It adds numbers of different units, as
    /// the tables of other programs do.
    pub error_10: f64,
    /// The error at t = 10 s without a unit, the mean over tops: the larger of |ΔΠ|/|Π| and |ΔΓ|/|Γ|, with the largest |Π|
    /// and |Γ| of the references.
    pub relative_error_10: f64,
    /// The end of the run, s.
    pub end: f64,
    /// The 2-norm of the error of (Π, Γ) at the end in SI units, the mean over tops.
    pub error_end: f64,
    /// The error at the end without a unit, the mean over tops, as `relative_error_10`.
    pub relative_error_end: f64,
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
    problem: &TimedProblem,
    run: &mut dyn FnMut(u64) -> Result<Vec<Se3Dual>, RunFailure>,
) -> Result<TimedRun, RunFailure> {
    let steps = |time: f64| (time / step).round() as u64;
    let sizes: Vec<_> = problem.sizes().collect();
    let [error_10, relative_error_10] = mean_errors(&run(steps(EARLY))?, &problem.early, &sizes);
    let [error_end, relative_error_end] =
        mean_errors(&run(steps(problem.end))?, &problem.late, &sizes);
    let (begin, mut least, mut repeats) = (Instant::now(), Duration::MAX, 0);
    while repeats < 2 || begin.elapsed() < LEAST || (repeats < REPEATS && begin.elapsed() < MOST) {
        let started = Instant::now();
        black_box(run(black_box(steps(problem.end)))?);
        least = least.min(started.elapsed());
        repeats += 1;
    }
    Ok(TimedRun {
        name: name.to_owned(),
        setting: format!("h = {step}"),
        tops: problem.tops,
        seconds: least.as_secs_f64(),
        steps: steps(problem.end),
        error_10,
        relative_error_10,
        end: problem.end,
        error_end,
        relative_error_end,
    })
}

/// Returns the mean over tops of the 2-norm of the error in SI units, and of the error relative to the sizes.
fn mean_errors(
    states: &[Se3Dual],
    reference: &[Se3Dual],
    sizes: &[BlockScales<Se3Dual>],
) -> [f64; 2] {
    let norm = |Covector(Pair(pi, gamma)): Se3Dual| pi.norm().hypot(gamma.norm());
    let errors = || states.iter().zip(reference).map(|(mu, exact)| *mu - *exact);
    let relative = errors().zip(sizes).map(|(error, sizes)| sizes.largest(&error));
    let count = reference.len() as f64;
    [errors().map(norm).sum::<f64>() / count, relative.sum::<f64>() / count]
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    /// In other units of mass the relative error is the same. Control: the 2-norm is not proportional to anything.
    #[test]
    fn relative_errors_are_the_same_in_all_units() {
        let measured = |unit: f64| {
            let exact = Se3Dual::new(Vector3::new(3.0, 0.0, 4.0) * unit, Vector3::y());
            let error = Se3Dual::new(Vector3::x() * (2e-9 * unit), Vector3::z() * 3e-10);
            mean_errors(&[exact + error], &[exact], &[BlockScales::of(&exact)])
        };
        let [norm, _] = measured(1.0);
        for unit in [1e-30, 1e-15, 1e-6, 1e6, 1e15, 1e30] {
            let [other, relative] = measured(unit);
            // Rounded by 1e-16 of the state, which is 4e-7 of the error.
            assert!((relative / 4e-10 - 1.0).abs() < 1e-6, "{unit:e} {relative:e}");
            assert!((other / norm / unit - 1.0).abs() > 0.005, "{unit:e} {other:e}");
        }
    }
}
