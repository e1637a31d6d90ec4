//! The accuracy of a run in its summary and in a warning.

use crate::Error;
use collective_integrators::RunError;
use collective_integrators::diagnostics::{RunAccuracy, StepCheck};
use heavytop::methods::{Formulation, SchemeName};
use serde::Serialize;
use std::fmt;

/// The result of a check of the whole run: `error` and `order` in the summary.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RunCheck {
    /// The error at the end: the largest |Δμ_b|/|μ_b| over the blocks b of coordinates, at most 1.
    pub error: f64,
    /// The order with which the run converges; `None` if the differences are round-off.
    pub order: Option<f64>,
}

impl RunCheck {
    /// Reads the result of a check.
    ///
    /// # Errors
    /// If a step failed, or the check was stopped.
    pub(super) fn of(
        checked: Result<Option<StepCheck>, RunError>,
        (formulation, scheme): (Formulation, SchemeName),
    ) -> Result<Self, Error> {
        match checked {
            Ok(Some(StepCheck { error, order })) => Ok(Self { error, order }),
            Ok(None) => Err(Error::Interrupted { resume: None }),
            Err(RunError::Integration(source)) => Err(Error::Integration {
                formulation: formulation.name(),
                scheme: scheme.name(),
                source,
            }),
            Err(other) => Err(other.into()),
        }
    }
}

/// Returns the warning about the accuracy of a run, if there is one.
pub(crate) fn accuracy_warning(accuracy: &RunAccuracy) -> Option<String> {
    accuracy.warning().map(|text| format!("warning: {text}"))
}

/// Writes the estimated error, and that of a check, as a part of a closing line.
pub(crate) fn write_accuracy(
    to: &mut fmt::Formatter<'_>,
    estimate: Option<f64>,
    check: Option<&RunCheck>,
) -> fmt::Result {
    match estimate {
        Some(error) => write!(to, "; estimated error {error:.1e} of the state")?,
        None => write!(to, "; no estimate of the error")?,
    }
    match check {
        Some(RunCheck { error, order: Some(order) }) => {
            write!(to, "; checked: {error:.1e} at the end, order {order:.1}")
        }
        Some(RunCheck { error, order: None }) => {
            write!(to, "; checked: {error:.1e} at the end, which is round-off")
        }
        None => Ok(()),
    }
}
