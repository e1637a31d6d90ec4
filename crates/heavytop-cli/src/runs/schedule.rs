//! The number of steps of a run.

use crate::Error;

/// More steps than this are a typing error.
const MOST_STEPS: f64 = 1e12;

/// How far the end may be from a whole number of steps, relative to the end.
const SLACK: f64 = 1e-9;

/// Equal steps from t = 0 to the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    /// The time step, s.
    pub step: f64,
    /// The number of steps, at least 1.
    pub steps: u64,
}

impl Schedule {
    /// The steps of size `step` (s) from 0 to `end` (s).
    ///
    /// # Errors
    /// Unless both are positive and finite, and the end is a whole number of steps to within
    /// 1e-9 of itself.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::runs::Schedule;
    /// assert_eq!(Schedule::new(0.02, 100.0)?.steps, 5000);
    /// assert!(Schedule::new(0.03, 100.0).is_err());
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn new(step: f64, end: f64) -> Result<Self, Error> {
        for (name, value) in [("step", step), ("end", end)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::OutOfRange { name, range: "positive and finite", value });
            }
        }
        let steps = (end / step).round();
        if steps > MOST_STEPS {
            return Err(Error::TooManySteps { steps, most: MOST_STEPS });
        }
        if (steps * step - end).abs() > SLACK * end {
            let before = (end / step).floor();
            let [before, after] = [before, before + 1.0].map(|n| n * step);
            return Err(Error::BrokenStep { end, step, before, after });
        }
        Ok(Self { step, steps: steps as u64 })
    }

    /// The time after the last step, s.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.steps as f64 * self.step
    }
}
