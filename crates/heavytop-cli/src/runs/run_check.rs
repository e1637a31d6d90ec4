//! The accuracy of a run in its summary and in a warning.

use crate::errors::Error;
use crate::vocabulary::brief::number;
use collective_integrators::RunError;
use collective_integrators::diagnostics::{NoOrder, RunAccuracy, StepCheck};
use heavytop::methods::Method;
use lie_poisson::larger;
use serde::{Serialize, Serializer};
use std::fmt;

/// The result of a check of the whole run: `error` and `order` in the summary.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RunCheck {
    /// The error at the end: the largest |Δμ_b|/|μ_b| over the blocks b of coordinates, at most 1; `None` if the check was
    /// interrupted, or the error is not a number.
    pub error: Option<f64>,
    /// The order with which the run converges, if the check shows one.
    pub order: Option<f64>,
    /// Why there is no order.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_order: Option<WithoutOrder>,
}

/// The reason why a check shows no order; its text in the summary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WithoutOrder {
    /// The check was interrupted.
    Interrupted,
    /// The differences between the runs show none.
    Shown(NoOrder),
}

impl fmt::Display for WithoutOrder {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Interrupted => to.write_str("the check was interrupted"),
            Self::Shown(reason) => reason.fmt(to),
        }
    }
}

impl Serialize for WithoutOrder {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl RunCheck {
    /// Reads the result of a check.
    ///
    /// # Errors
    /// If a step failed.
    pub(crate) fn of(
        checked: Result<Option<StepCheck>, RunError>,
        method: &Method,
    ) -> Result<Self, Error> {
        match checked {
            Ok(Some(StepCheck { error, order })) => {
                let no_order = order.err().map(WithoutOrder::Shown);
                Ok(Self { error, order: order.ok(), no_order })
            }
            Ok(None) => {
                Ok(Self { error: None, order: None, no_order: Some(WithoutOrder::Interrupted) })
            }
            Err(RunError::Integration(source)) => {
                Err(lie_poisson_runs::RunFailure::of_step(method, source).into())
            }
            Err(other) => Err(other.into()),
        }
    }

    /// Returns whether the check was interrupted.
    #[must_use]
    pub fn was_interrupted(&self) -> bool {
        self.no_order == Some(WithoutOrder::Interrupted)
    }
}

impl fmt::Display for RunCheck {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.error, self.no_order) {
            (_, Some(WithoutOrder::Interrupted)) => {
                return to.write_str("the check was interrupted");
            }
            (Some(error), _) => write!(to, "checked: {error:.1e} at the end")?,
            (None, _) => write!(to, "checked: the error at the end is not a number")?,
        }
        match (self.order, self.no_order) {
            (Some(order), _) => write!(to, ", order {order:.1}"),
            (None, Some(reason)) => write!(to, ", no order: {reason}"),
            (None, None) => Ok(()),
        }
    }
}

impl RunCheck {
    /// Returns a warning if the check finds a large error that the estimate has not shown.
    pub(crate) fn warning(&self, estimate: &RunAccuracy) -> Option<String> {
        let error = self.error.filter(|error| *error > RunAccuracy::MOST_ERROR)?;
        let is_said = estimate.error.is_some_and(|estimate| estimate > RunAccuracy::MOST_ERROR);
        (!is_said).then(|| {
            format!(
                "warning: the run with half the step ends elsewhere: the relative error is about {error:.1e}, though the \
                 beginning of the run does not show it; where shorter steps do not help, the motion is chaotic"
            )
        })
    }
}

/// Returns the larger angle of a step and the larger error of two runs by one method.
pub(crate) fn worse(one: RunAccuracy, other: RunAccuracy) -> RunAccuracy {
    RunAccuracy {
        angle: larger(one.angle, other.angle),
        error: one.error.into_iter().chain(other.error).reduce(larger),
        chaos: one.chaos.into_iter().chain(other.chaos).reduce(f64::min),
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

/// Writes the estimated error of the state, or of a path, and that of a check, as a part of a closing line.
pub(crate) fn write_accuracy(
    to: &mut fmt::Formatter<'_>,
    (estimate, what): (Option<f64>, &str),
    check: Option<&RunCheck>,
) -> fmt::Result {
    match estimate {
        Some(error) => write!(to, "; estimated error {error:.1e} of {what}")?,
        None => write!(to, "; no estimate of the error")?,
    }
    check.map_or(Ok(()), |check| write!(to, "; {check}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_check_warns_of_what_the_estimate_has_not_shown() {
        let check = |error| RunCheck { error, order: None, no_order: None };
        let estimate = |error| RunAccuracy { step: 0.1, order: 8, angle: 0.1, error, chaos: None };
        let warning = check(Some(0.5)).warning(&estimate(Some(1e-9)));
        assert!(warning.is_some_and(|text| text.contains("about 5.0e-1")));
        // Controls: a small error, and one that has been told.
        assert_eq!(check(Some(1e-4)).warning(&estimate(Some(1e-9))), None);
        assert_eq!(check(Some(0.5)).warning(&estimate(Some(1.0))), None);
        assert_eq!(check(None).warning(&estimate(None)), None);
    }
}
