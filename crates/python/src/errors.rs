//! Errors as Python exceptions.

use core::error::Error;
use pyo3::PyErr;
use pyo3::exceptions::{PyRuntimeError, PyValueError};

pyo3::create_exception!(
    heavytop,
    IntegrationError,
    PyRuntimeError,
    "A step has no result: its stage equations did not converge, or its state is not finite."
);

/// Returns the message of an error with its causes.
pub(crate) fn message(error: &dyn Error) -> String {
    let mut message = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        message = format!("{message}: {error}");
        cause = error.source();
    }
    message
}

/// Converts the error of an argument to `ValueError`.
pub(crate) fn refused(error: impl Error) -> PyErr {
    PyValueError::new_err(message(&error))
}

/// Converts the error of a step to `IntegrationError`.
pub(crate) fn failed(error: impl Error) -> PyErr {
    IntegrationError::new_err(message(&error))
}
