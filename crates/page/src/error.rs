//! Errors of the page.

use collective_integrators::{EventError, IntegrationError, SchemeError, StepError};
use heavytop::{SectionError, TopError};
use lie_poisson::MissingInstructions;
use momentum_map::LiftError;
use thiserror::Error;

/// The reason why the page cannot do what it is asked for.
///
/// [`message`](Self::message) is the text that the page shows.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PageError {
    /// The parameters are not those of a top.
    #[error(transparent)]
    Top(#[from] TopError),
    /// The method does not exist.
    #[error(transparent)]
    Scheme(#[from] SchemeError),
    /// The instruction set is not here.
    #[error(transparent)]
    Instructions(#[from] MissingInstructions),
    /// The momentum of the start has no lift.
    #[error(transparent)]
    Lift(#[from] LiftError),
    /// A step of the integrator failed.
    #[error(transparent)]
    Step(#[from] IntegrationError),
    /// A crossing of the section cannot be located.
    #[error(transparent)]
    Crossing(#[from] EventError),
    /// The section does not exist.
    #[error(transparent)]
    Section(#[from] SectionError),
    /// No state of the section is at this point.
    #[error("no state of this energy and Π·Γ is at ({x}, {y}) of the section")]
    NotAccessible {
        /// The angle of Γ about the axis, rad.
        x: f64,
        /// The other coordinate of the section.
        y: f64,
    },
    /// An invariant has become too large for a number.
    #[error("{symbol} is not finite at t = {time}: the motion has blown up")]
    NotFinite {
        /// The symbol of the invariant.
        symbol: &'static str,
        /// The time of the first step after which it is not finite, s.
        time: f64,
    },
    /// The step size is not positive.
    #[error("the step must be a positive number, it is {step}")]
    StepSize {
        /// The refused step size, s.
        step: f64,
    },
    /// The friction is not a number of at least 0 with which this top moves.
    #[error(
        "the friction must be at least 0, and finite after a division by each moment, it is {coefficient}"
    )]
    Friction {
        /// The refused coefficient c, N m s.
        coefficient: f64,
    },
    /// Nothing of this kind has the number.
    #[error("there is no {kind} with the number {number}")]
    Unknown {
        /// What was asked for: a method or a coordinate.
        kind: &'static str,
        /// The number that was asked for.
        number: u32,
    },
    /// Nothing was thrown yet.
    #[error("throw a top first")]
    NotThrown,
}

impl PageError {
    /// Creates the error of the step that follows `made` steps and begins at a time.
    pub(crate) fn of_step(made: u64, time: f64, source: StepError) -> Self {
        Self::Step(IntegrationError { step: made.saturating_add(1), time, source })
    }

    /// Returns the message, with the messages of its sources after it.
    #[must_use]
    pub fn message(&self) -> String {
        let mut message = self.to_string();
        let mut source = std::error::Error::source(self);
        while let Some(error) = source {
            message = format!("{message}: {error}");
            source = error.source();
        }
        message
    }
}
