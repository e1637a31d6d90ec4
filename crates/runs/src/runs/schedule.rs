//! The schedule of a run: its step size and number of steps.

use crate::error::RunFailure;

/// The largest number of steps; more must be a typing error.
pub const MOST_STEPS: f64 = 1e12;

/// The largest distance of the end from a whole number of steps, relative to the end.
const SLACK: f64 = 1e-9;

/// Equal steps from t = 0 to the end, which is before 0 for a run backward in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    /// The time step, s, negative for a run backward in time.
    pub step: f64,
    /// The number of steps, at least 1.
    pub steps: u64,
}

/// Returns the step (s) of a run to `end` (s), with its sign. An end before 0 alone asks for a run backward in time.
///
/// # Errors
/// If one of the two is 0 or not finite, or the step is negative and the end is not.
///
/// # Example
/// ```
/// use lie_poisson_runs::directed_step;
/// assert_eq!(directed_step(0.1, -5.0)?, -0.1);
/// assert!(directed_step(-0.1, 5.0).is_err());
/// # Ok::<(), lie_poisson_runs::RunFailure>(())
/// ```
pub fn directed_step(step: f64, end: f64) -> Result<f64, RunFailure> {
    for (name, value) in [("step", step), ("end", end)] {
        if value == 0.0 || !value.is_finite() {
            return Err(RunFailure::NoDirection { name, value });
        }
    }
    if step < 0.0 && end > 0.0 {
        return Err(RunFailure::OppositeEnd { step, end });
    }
    Ok(step.copysign(end))
}

/// Rounds to twelve digits, which is far closer than the slack.
fn short(end: f64) -> f64 {
    format!("{end:.11e}").parse().unwrap_or(end)
}

impl Schedule {
    /// Creates the schedule of steps of size `step` (s) from 0 to `end` (s). If the end is negative, so are the steps, with
    /// or without a sign of `step`.
    ///
    /// # Errors
    /// If one of the two is 0 or not finite, the step is negative and the end is not, or the end differs from a whole
    /// number of steps by more than 1e-9 of itself.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_runs::Schedule;
    /// assert_eq!(Schedule::new(0.02, 100.0)?.steps, 5000);
    /// assert!(Schedule::new(0.03, 100.0).is_err());
    /// assert_eq!(Schedule::new(0.02, -100.0)?, Schedule::new(-0.02, -100.0)?);
    /// assert!(Schedule::new(-0.02, 100.0).is_err());
    /// # Ok::<(), lie_poisson_runs::RunFailure>(())
    /// ```
    pub fn new(step: f64, end: f64) -> Result<Self, RunFailure> {
        let step = directed_step(step, end)?;
        let steps = (end / step).round();
        if steps > MOST_STEPS {
            return Err(RunFailure::TooManySteps { steps, most: MOST_STEPS });
        }
        if (steps * step - end).abs() > SLACK * end.abs() {
            let before = (end / step).floor();
            let [before, after] = [before, before + 1.0].map(|n| short(n * step));
            return Err(RunFailure::BrokenStep { end, step, before, after });
        }
        Ok(Self { step, steps: steps as u64 })
    }

    /// Returns the time after the last step, s.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.steps as f64 * self.step
    }
}
