//! The convergence test of sweeps for generators: [`Sweeps`].

use crate::matrices::skew_hermitian::LargeSkewHermitian;
use collective_integrators::StepError;
use lie_poisson::State;

/// The number of sweeps after which an iteration counts as not converged.
const MOST_SWEEPS: usize = 100;

/// The multiple of the size of a generator below which changes that no longer decrease are round-off.
///
/// The generator may be small by cancellation, as Δ⁻¹W is for a W of high degree.
const FLOOR: f64 = 1e-11;

/// The multiple of the size of a generator below which a change is round-off.
const ROUND_OFF: f64 = 4.0 * f64::EPSILON;

/// Sweeps of a fixed-point iteration for generators B, watched until they no longer change, or change by less than the
/// tolerance.
pub(crate) struct Sweeps {
    tolerance: f64,
    length: f64,
    last: f64,
    size: f64,
    pub(crate) made: usize,
}

impl Sweeps {
    /// Creates the watch for a step of the given size. The largest accepted change h |δB| is `tolerance`.
    pub(crate) fn new(tolerance: f64, step: f64) -> Self {
        Self { tolerance, length: step.abs(), last: f64::INFINITY, size: 0.0, made: 0 }
    }

    /// Records the next sweep, from the pairs of new and old generators. Returns whether it is the last one.
    ///
    /// # Errors
    /// Returns [`StepError::NotConverged`] if a change is not finite, or after 100 sweeps. Its residual is h |δB| if
    /// there is a tolerance, and otherwise |δB|/|B|.
    pub(crate) fn converged(
        &mut self,
        new: &[LargeSkewHermitian],
        old: &[LargeSkewHermitian],
    ) -> Result<bool, StepError> {
        let (mut change, mut size) = ((0.0,), (0.0,));
        let mut sums = (0.0, 0.0);
        for (new, old) in new.iter().zip(old) {
            new.measure_difference(old, &mut change, &mut sums.0);
            new.measure(&mut size, &mut sums.1);
        }
        let ((change,), (size,)) = (change, size);
        let finite = sums.0.is_finite() && sums.1.is_finite();
        self.made += 1;
        let enough = self.length * change <= self.tolerance || change <= size * ROUND_OFF;
        let floor = change >= self.last && change <= size * FLOOR;
        self.last = change;
        self.size = size;
        if finite && (enough || floor) {
            return Ok(true);
        }
        if finite && self.made < MOST_SWEEPS {
            return Ok(false);
        }
        let (residual, required) = if self.tolerance > 0.0 {
            (self.length * change, self.tolerance)
        } else {
            (change / size, ROUND_OFF)
        };
        let residual = if finite { residual } else { f64::NAN };
        Err(StepError::NotConverged { residual, required, iterations: self.made })
    }

    /// Returns the last change, relative to the size; ∞ before the second sweep.
    pub(crate) fn relative_change(&self) -> f64 {
        if self.size > 0.0 { self.last / self.size } else { f64::INFINITY }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
mod tests {
    use super::*;
    use num_complex::Complex;

    /// After 100 sweeps the error has the last change, relative to the generator where no tolerance is given, and as
    /// the change of the step where there is one.
    #[test]
    fn the_residual_of_sweeps_without_end_is_their_last_change() {
        let of_size = |x: f64| [LargeSkewHermitian::from_upper(1, |_, _| Complex::new(0.0, x))];
        for unit in [1.0, 1e-30, 1e30] {
            let (old, new) = (of_size(4.0 * unit), of_size(3.0 * unit));
            let end = |tolerance: f64| {
                let mut sweeps = Sweeps::new(tolerance, -0.5);
                (1..MOST_SWEEPS).for_each(|_| assert!(!sweeps.converged(&new, &old).unwrap()));
                sweeps.converged(&new, &old).unwrap_err()
            };
            let (change, close) = (unit * 0.5, unit * 1e-12);
            for (tolerance, expected, bound) in
                [(0.0, 1.0 / 3.0, ROUND_OFF), (close, change, close)]
            {
                let StepError::NotConverged { residual, required, iterations } = end(tolerance)
                else {
                    panic!("another error")
                };
                // A few roundings of the quotient.
                assert!((residual / expected - 1.0).abs() < 1e-15, "{unit:e}: {residual:e}");
                assert_eq!((required, iterations), (bound, MOST_SWEEPS));
            }
        }
    }
}
