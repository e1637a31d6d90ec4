//! The state at t = 0, and equal steps to an end after or before it: [`Schedule`].

use collective_integrators::AnyState;
use pyo3::exceptions::PyValueError;
use pyo3::{PyErr, PyResult};

/// The largest number of steps; more must be a typing error.
const MOST_STEPS: f64 = 1e12;

/// The largest distance of the end from a whole number of steps, relative to the end.
const SLACK: f64 = 1e-9;

/// The state at t = 0, and the steps of a run.
#[derive(Clone, Debug)]
pub(crate) struct Schedule {
    /// The coordinates of the state at t = 0.
    pub(crate) start: Vec<f64>,
    /// The size of a step, negative for a run backward in time.
    pub(crate) step: f64,
    /// The number of steps.
    pub(crate) steps: u64,
}

impl Schedule {
    /// Creates the steps from a state to an end.
    pub(crate) fn new(start: Vec<f64>, step: f64, end: f64) -> PyResult<Self> {
        Ok(Self { start, step, steps: steps(step, end)? })
    }

    /// Returns the state at t = 0.
    pub(crate) fn start(&self) -> AnyState {
        AnyState::from_slice(&self.start)
    }
}

/// Returns the number of steps from 0 to the end. Both are negative for a run backward in time.
pub(crate) fn steps(step: f64, end: f64) -> PyResult<u64> {
    for (name, value) in [("step", step), ("end", end)] {
        if value == 0.0 || !value.is_finite() {
            let text = format!("{name} must be finite and different from 0, got {value:?}");
            return Err(refused(text));
        }
    }
    if (step > 0.0) != (end > 0.0) {
        return Err(refused(format!("step and end must have the same sign, got {step} and {end}")));
    }
    let count = (end / step).round();
    if count > MOST_STEPS {
        return Err(refused(format!("{count:e} steps are more than {MOST_STEPS:e}")));
    }
    if (count * step - end).abs() > SLACK * end.abs() {
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
