//! The steps of a run from Python's step and end.

use crate::errors::refused;
use lie_poisson_runs::Schedule;
use pyo3::PyResult;
use pyo3::exceptions::PyValueError;

/// Creates the steps from 0 to the end. Both are negative for a run backward in time.
///
/// # Errors
/// Returns `ValueError` if one of them is 0 or not finite, they have different signs, or the end is not a whole number of
/// steps.
pub(crate) fn schedule(step: f64, end: f64) -> PyResult<Schedule> {
    if step * end < 0.0 {
        let text = format!("step and end must have the same sign, got {step} and {end}");
        return Err(PyValueError::new_err(text));
    }
    Schedule::new(step, end).map_err(refused)
}
