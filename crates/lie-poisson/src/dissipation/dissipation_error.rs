//! What friction and a temperature must be: [`DissipationError`].

use thiserror::Error;

/// The error returned for a friction that would feed energy, a temperature below zero, or one of them that is no number.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DissipationError {
    /// The friction is negative or no finite number.
    #[error("the friction must be 0 or a positive number, it is {friction}")]
    Friction {
        /// The rejected friction.
        friction: f64,
    },
    /// The temperature is negative or no finite number.
    #[error("the temperature must be 0 or a positive number, it is {temperature}")]
    Temperature {
        /// The rejected temperature.
        temperature: f64,
    },
}

/// Requires that a friction is a finite number of at least 0.
pub(crate) fn require_friction(friction: f64) -> Result<(), DissipationError> {
    match friction >= 0.0 && friction.is_finite() {
        true => Ok(()),
        false => Err(DissipationError::Friction { friction }),
    }
}
