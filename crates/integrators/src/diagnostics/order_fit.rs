//! The order of convergence, measured.

use thiserror::Error;

/// Too little to fit an order to.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("an order needs at least 3 errors above the round-off plateau {plateau:e}, got {usable}")]
pub struct OrderFitError {
    /// Usable points.
    pub usable: usize,
    /// The plateau below which errors were left out.
    pub plateau: f64,
}

/// The slope of ln(error) against ln(step), by least squares over the errors above `plateau`.
///
/// Errors at the round-off plateau say nothing about the order and are left out, as are those
/// that are not finite.
///
/// # Errors
/// If fewer than three points remain.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::{OrderFitError, fitted_order};
/// let points = [0.4, 0.2, 0.1, 0.05].map(|h: f64| (h, 3.0 * h.powi(4)));
/// assert!((fitted_order(&points, 1e-13)? - 4.0).abs() < 1e-12);
/// // two of the four are below the plateau: nothing is claimed
/// assert!(fitted_order(&points, 1e-3).is_err());
/// # Ok::<(), OrderFitError>(())
/// ```
pub fn fitted_order(steps_and_errors: &[(f64, f64)], plateau: f64) -> Result<f64, OrderFitError> {
    let points: Vec<(f64, f64)> = steps_and_errors
        .iter()
        .filter(|(_, error)| *error > plateau && error.is_finite())
        .map(|(step, error)| (step.abs().ln(), error.ln()))
        .collect();
    if points.len() < 3 {
        return Err(OrderFitError { usable: points.len(), plateau });
    }
    let n = points.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let covariance = mean(&|p| (p.0 - x) * (p.1 - y));
    let variance = mean(&|p| (p.0 - x) * (p.0 - x));
    Ok(covariance / variance)
}
