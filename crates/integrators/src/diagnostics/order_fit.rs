//! The order of convergence, fitted to measured errors: [`fitted_order`].

use thiserror::Error;

/// The reason why no order can be fitted.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OrderFitError {
    /// Too few errors lie above the round-off plateau.
    #[error(
        "an order needs at least 3 errors above the round-off plateau {plateau:e}, got {usable}"
    )]
    TooFew {
        /// The number of usable errors.
        usable: usize,
        /// The plateau; errors below it are left out.
        plateau: f64,
    },
    /// A step or an error is infinite or not a number. Such a run has no result; it does not count as a small error.
    #[error("step {step} has the error {error}")]
    NotFinite {
        /// The step size.
        step: f64,
        /// The error of the step.
        error: f64,
    },
    /// All usable errors belong to one step size.
    #[error("an order needs different steps, all are {step}")]
    OneStep {
        /// The step size.
        step: f64,
    },
}

/// Returns the slope of ln(error) against ln |step|, by least squares over the errors above `plateau`.
///
/// Errors at the round-off plateau contain no information about the order and are left out.
///
/// # Errors
/// Returns [`OrderFitError::TooFew`] if fewer than three points remain, [`OrderFitError::OneStep`] if all have the same
/// step, and [`OrderFitError::NotFinite`] if a step or an error is not finite. A method that fails for some of the
/// steps has no order.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::{OrderFitError, fitted_order};
/// let points = [0.4, 0.2, 0.1, 0.05].map(|h: f64| (h, 3.0 * h.powi(4)));
/// assert!((fitted_order(&points, 1e-13)? - 4.0).abs() < 1e-12);
/// // two of the four are below the plateau, and too few remain
/// assert!(fitted_order(&points, 1e-3).is_err());
/// # Ok::<(), OrderFitError>(())
/// ```
pub fn fitted_order(steps_and_errors: &[(f64, f64)], plateau: f64) -> Result<f64, OrderFitError> {
    let broken = |(step, error): &&(f64, f64)| !step.is_finite() || !error.is_finite();
    if let Some(&(step, error)) = steps_and_errors.iter().find(broken) {
        return Err(OrderFitError::NotFinite { step, error });
    }
    let points: Vec<(f64, f64)> = steps_and_errors
        .iter()
        .filter(|(step, error)| *error > plateau && *error > 0.0 && *step != 0.0)
        .map(|(step, error)| (step.abs().ln(), error.ln()))
        .collect();
    if points.len() < 3 {
        return Err(OrderFitError::TooFew { usable: points.len(), plateau });
    }
    let n = points.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let covariance = mean(&|p| (p.0 - x) * (p.1 - y));
    let variance = mean(&|p| (p.0 - x) * (p.0 - x));
    if points.iter().all(|p| p.0 == points[0].0) {
        return Err(OrderFitError::OneStep { step: points[0].0.exp() });
    }
    Ok(covariance / variance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_order_is_an_error() {
        let points = |error: f64| [(0.4, 1e-2), (0.2, 1e-3), (0.1, 1e-4), (0.05, error)];
        assert!(fitted_order(&points(1e-5), 0.0).is_ok());
        for error in [f64::NAN, f64::INFINITY] {
            let fit = fitted_order(&points(error), 0.0);
            assert!(matches!(fit, Err(OrderFitError::NotFinite { step: 0.05, .. })));
        }
        let few = OrderFitError::TooFew { usable: 2, plateau: 5e-4 };
        assert_eq!(fitted_order(&points(0.0), 5e-4), Err(few));
        let same = fitted_order(&[(0.1, 1.0), (-0.1, 2.0), (0.1, 3.0)], 0.0);
        assert!(matches!(same, Err(OrderFitError::OneStep { .. })));
    }
}
