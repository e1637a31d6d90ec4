//! The accuracy of a run in its summary and in a warning.

use crate::Error;
use crate::vocabulary::brief::number;
use collective_integrators::RunError;
use collective_integrators::diagnostics::{RunAccuracy, StepCheck};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::larger;
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

/// Returns the larger angle of a step and the larger error of two runs by one method.
pub(crate) fn worse(one: RunAccuracy, other: RunAccuracy) -> RunAccuracy {
    RunAccuracy {
        angle: larger(one.angle, other.angle),
        error: one.error.into_iter().chain(other.error).reduce(larger),
        ..one
    }
}

/// Returns the warning about the accuracy of a run, if there is one.
pub(crate) fn accuracy_warning(accuracy: &RunAccuracy) -> Option<String> {
    accuracy.warning().map(|text| format!("warning: {text}"))
}

/// Writes the method, the steps (s) and the end (s) as a part of a closing line, so that it names what was left out.
pub(crate) fn write_method(
    to: &mut fmt::Formatter<'_>,
    (formulation, scheme): (&str, &str),
    (step, end): (f64, f64),
) -> fmt::Result {
    write!(to, "; by {formulation}, {scheme}, step {} s, to {} s", number(step), number(end))
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
