//! The change of a conserved quantity along a run: [`Drift`].

use crate::diagnostics::order_fit::OrderFitError;
use crate::error::IntegrationError;
use crate::integrators::trajectories::sample::Sample;
use lie_poisson::larger;
use thiserror::Error;

/// The reason why the statistics of a drift cannot be computed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DriftError {
    /// The run ended with an error.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// There are too few values: a fitted line needs values at two different times.
    #[error("a drift needs values at 2 different times, got {samples} values")]
    TooFewSamples {
        /// The number of values.
        samples: usize,
    },
    /// A value is infinite or not a number.
    #[error("the quantity is {value} at t = {time}")]
    NotFinite {
        /// The time of the value.
        time: f64,
        /// The value that is not finite.
        value: f64,
    },
    /// The times of a run of an ensemble differ from those of the first run.
    #[error("run {run} of the ensemble differs from the first in its times, at value {sample}")]
    Times {
        /// The index of the run; the first is 0.
        run: usize,
        /// The index of the first value whose time differs, or that is missing.
        sample: usize,
    },
    /// There are too few points above the plateau to fit an exponent.
    #[error("the growth has no exponent: {0}")]
    Exponent(OrderFitError),
}

impl From<OrderFitError> for DriftError {
    fn from(error: OrderFitError) -> Self {
        Self::Exponent(error)
    }
}

/// The change of a quantity f over a run that should conserve it.
///
/// A symplectic method of order p lets the energy oscillate: `largest` is of size hᵖ, and `slope` is only what remains
/// of the oscillation. It is at most 3 `largest` divided by the length of the run, and far smaller over many periods.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::Drift;
/// use collective_integrators::{Direct, RungeKutta, Start, from_fn};
/// use nalgebra::Vector2;
/// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
/// let energy = |z: &Vector2<f64>| 0.5 * z.y * z.y - z.x.cos();
/// let drift = |scheme: RungeKutta| -> Result<Drift, Box<dyn std::error::Error>> {
///     let integrator = Direct::new(scheme, pendulum);
///     let run = integrator.trajectory(&Vector2::new(1.0, 0.5), 0.1)?.take(10_000);
///     Ok(Drift::along(run, energy)?)
/// };
/// let (midpoint, rk4) = (drift(RungeKutta::implicit_midpoint())?, drift(RungeKutta::rk4())?);
/// assert!(midpoint.largest < 1e-3 && midpoint.slope.abs() < 1e-9);
/// // at first a much smaller error, but a permanent loss
/// assert!(rk4.slope < -1e-8 && rk4.largest > 900.0 * rk4.slope.abs());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Drift {
    /// The number of values.
    pub samples: usize,
    /// The largest change max |f(t) − f(0)|, in the units of f.
    pub largest: f64,
    /// The slope of f against t by least squares, in the units of f per unit of time.
    pub slope: f64,
}

impl Drift {
    /// Computes the drift of the pairs (t, f(t)), in constant storage.
    ///
    /// # Errors
    /// Returns [`DriftError::NotFinite`] if a value or a time is not finite, or [`DriftError::TooFewSamples`] if there
    /// are no two different times.
    pub fn of(values: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, DriftError> {
        let mut line = Line::default();
        for (time, value) in values {
            line.add(time, value)?;
        }
        line.drift()
    }

    /// Computes the drift of f(μ) along a trajectory, which must be finite: `trajectory.take(n)`.
    ///
    /// # Errors
    /// Returns [`DriftError::Integration`] if the run fails, and the errors of [`Drift::of`].
    pub fn along<S, M>(
        trajectory: impl IntoIterator<Item = Result<Sample<S, M>, IntegrationError>>,
        f: impl Fn(&M) -> f64,
    ) -> Result<Self, DriftError> {
        let mut line = Line::default();
        for sample in trajectory {
            let sample = sample?;
            line.add(sample.time, f(&sample.momentum))?;
        }
        line.drift()
    }
}

/// The moments of (t, f(t) − f(0)), updated value by value.
///
/// Source: B. P. Welford, *Note on a method for calculating corrected sums of squares and
/// products*, Technometrics 4 (1962).
#[derive(Default)]
struct Line {
    first: Option<f64>,
    samples: usize,
    largest: f64,
    time: f64,
    deviation: f64,
    covariance: f64,
    variance: f64,
}

impl Line {
    fn add(&mut self, time: f64, value: f64) -> Result<(), DriftError> {
        if !value.is_finite() || !time.is_finite() {
            return Err(DriftError::NotFinite { time, value });
        }
        let deviation = value - *self.first.get_or_insert(value);
        self.samples += 1;
        self.largest = larger(self.largest, deviation.abs());
        let n = self.samples as f64;
        let later = time - self.time;
        self.time += later / n;
        self.deviation += (deviation - self.deviation) / n;
        self.covariance += later * (deviation - self.deviation);
        self.variance += later * (time - self.time);
        Ok(())
    }

    fn drift(self) -> Result<Drift, DriftError> {
        let Self { samples, largest, covariance, variance, .. } = self;
        if variance > 0.0 {
            Ok(Drift { samples, largest, slope: covariance / variance })
        } else {
            Err(DriftError::TooFewSamples { samples })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_and_an_oscillation() {
        let values = |n: u32| (0..n).map(f64::from).map(|t| (t, 5.0 - 0.25 * t));
        let line = Drift { samples: 9, largest: 2.0, slope: -0.25 };
        assert_eq!(Drift::of(values(9)), Ok(line));
        let wave = (0..=1000).map(|n| (f64::from(n), f64::from(n % 2)));
        assert!(Drift::of(wave).is_ok_and(|d| d.largest == 1.0 && d.slope.abs() < 1e-12));
        assert_eq!(Drift::of(values(1)), Err(DriftError::TooFewSamples { samples: 1 }));
        assert_eq!(Drift::of([]), Err(DriftError::TooFewSamples { samples: 0 }));
    }

    #[test]
    fn a_nan_is_an_error() {
        let values = [(0.0, 1.0), (1.0, f64::NAN), (2.0, 1.0)];
        assert!(matches!(Drift::of(values), Err(DriftError::NotFinite { time: 1.0, .. })));
    }
}
