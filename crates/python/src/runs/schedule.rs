//! Equal steps from 0 to an end.

use pyo3::exceptions::PyValueError;
use pyo3::{PyErr, PyResult};

/// The largest number of steps; more must be a typing error.
const MOST_STEPS: f64 = 1e12;

/// The largest distance of the end from a whole number of steps, relative to the end.
const SLACK: f64 = 1e-9;

/// Returns the number of steps from 0 to the end.
pub(crate) fn steps(step: f64, end: f64) -> PyResult<u64> {
    for (name, value) in [("step", step), ("end", end)] {
        if !(value > 0.0 && value.is_finite()) {
            return Err(refused(format!("{name} must be positive and finite, got {value:?}")));
        }
    }
    let count = (end / step).round();
    if count > MOST_STEPS {
        return Err(refused(format!("{count:e} steps are more than {MOST_STEPS:e}")));
    }
    if (count * step - end).abs() > SLACK * end {
        let before = (end / step).floor();
        return Err(refused(format!(
            "end = {end} is not a whole number of steps of {step}; the nearest ends are {} and {}",
            before * step,
            (before + 1.0) * step
        )));
    }
    Ok(count as u64)
}

fn refused(message: String) -> PyErr {
    PyValueError::new_err(message)
}
