//! How accurate a run is, in the types of Python.

use crate::errors::{failed, refused};
use collective_integrators::RunError;
use collective_integrators::diagnostics::{RunAccuracy, StepCheck};
use lie_poisson_runs::Model;
use pyo3::PyResult;
use pyo3::exceptions::{PyArithmeticError, PyKeyboardInterrupt};

/// The angle of a step, rad, the estimated error, and the warning.
pub(crate) type Accuracy = (f64, Option<f64>, Option<String>);

/// The error at the end of a run, and the order with which it converges, if there is one.
pub(crate) type Check = (f64, Option<f64>);

/// Returns the accuracy of a run.
pub(crate) fn accuracy(model: &dyn Model, start: &[f64], measured: RunAccuracy) -> Accuracy {
    (measured.angle, measured.error, model.accuracy_warning(start, &measured))
}

/// Returns the result of a check, or the error of the step that failed.
pub(crate) fn check(checked: Result<Option<StepCheck>, RunError>) -> PyResult<Check> {
    match checked {
        Ok(Some(StepCheck { error: Some(error), order })) => Ok((error, order.ok())),
        Ok(Some(StepCheck { error: None, .. })) => Err(PyArithmeticError::new_err(
            "the error is not a number: the derivative of the Hamiltonian has no value during the run",
        )),
        Ok(None) => Err(PyKeyboardInterrupt::new_err(())),
        Err(RunError::Integration(error)) => Err(failed(error)),
        Err(error) => Err(refused(error)),
    }
}
