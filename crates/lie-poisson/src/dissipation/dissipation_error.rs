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

impl DissipationError {
    /// Requires that a friction is 0 or positive.
    ///
    /// # Errors
    /// Returns [`Friction`](Self::Friction) for one that is negative, infinite or NaN.
    pub fn require_friction(friction: f64) -> Result<(), Self> {
        match friction >= 0.0 && friction.is_finite() {
            true => Ok(()),
            false => Err(Self::Friction { friction }),
        }
    }

    /// Requires that a temperature is 0 or positive.
    ///
    /// # Errors
    /// Returns [`Temperature`](Self::Temperature) for one that is negative, infinite or NaN.
    pub fn require_temperature(temperature: f64) -> Result<(), Self> {
        match temperature >= 0.0 && temperature.is_finite() {
            true => Ok(()),
            false => Err(Self::Temperature { temperature }),
        }
    }
}
