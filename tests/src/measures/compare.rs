//! Comparison by error, where NaN counts as the largest error of all.

use lie_poisson::{Vector, larger};

/// Returns max |a − b| / max(|a|, |b|); 0 if both are 0, NaN if a coordinate is NaN.
pub fn relative_error<V: Vector<Scalar = f64>>(a: &V, b: &V) -> f64 {
    let size = larger(a.max_abs(), b.max_abs());
    if size == 0.0 { 0.0 } else { (*a - *b).max_abs() / size }
}

/// Asserts |a − b| ≤ tolerance · max(1, |a|, |b|) coordinate by coordinate: relative for large values, absolute for
/// small ones. Fails on NaN.
///
/// # Panics
/// If a and b differ by more.
#[track_caller]
pub fn assert_near<V: Vector<Scalar = f64>>(a: &V, b: &V, tolerance: f64) {
    let size = larger(1.0, larger(a.max_abs(), b.max_abs()));
    let error = (*a - *b).max_abs() / size;
    assert!(error <= tolerance, "error {error:e} above {tolerance:e} between\n{a:?} and\n{b:?}");
}

/// Asserts [`assert_near`] for two numbers.
///
/// # Panics
/// If a and b differ by more.
#[track_caller]
pub fn assert_close(a: f64, b: f64, tolerance: f64) {
    let error = (a - b).abs() / larger(1.0, larger(a.abs(), b.abs()));
    assert!(error <= tolerance, "error {error:e} above {tolerance:e} between {a} and {b}");
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn errors_are_seen() {
        let (a, b) = (Vector2::new(1e-9, 0.0), Vector2::new(2e-9, 0.0));
        assert_eq!(relative_error(&a, &b), 0.5);
        assert_eq!(relative_error(&Vector2::zeros(), &Vector2::<f64>::zeros()), 0.0);
        assert!(relative_error(&a, &Vector2::new(f64::NAN, 0.0)).is_nan());
        assert_near(&a, &b, 1e-8);
        assert_close(1e20, 1e20 * (1.0 + 1e-15), 1e-14);
    }

    #[test]
    #[should_panic(expected = "above")]
    fn a_nan_is_not_near() {
        assert_near(&Vector2::new(0.0, f64::NAN), &Vector2::zeros(), 1.0);
    }

    #[test]
    #[should_panic(expected = "above")]
    fn a_nan_is_not_close() {
        assert_close(f64::NAN, f64::NAN, 1.0);
    }
}
