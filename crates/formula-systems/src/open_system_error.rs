//! The errors of open systems: [`OpenSystemError`].

use collective_integrators::BrownianError;
use lie_poisson::{DissipationError, InnerProductError, InputTableError};
use lie_poisson_formulas::{FormulaError, NameError};
use thiserror::Error;

/// The reason why an open system cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OpenSystemError {
    /// The name of an input cannot be one, or is that of a coordinate, a parameter, or the time `t`.
    #[error("the input {name}: {reason}")]
    InputName {
        /// The name.
        name: String,
        /// What is wrong with it.
        reason: NameError,
    },
    /// The table of an input is no table, or is shorter than a run.
    #[error("the input {name}: {reason}")]
    Input {
        /// The name of the input.
        name: String,
        /// What is wrong with it.
        reason: InputTableError,
    },
    /// A formula is none.
    #[error("{what}: {reason}")]
    Formula {
        /// What the formula is for.
        what: String,
        /// What is wrong with it.
        reason: Box<FormulaError>,
    },
    /// There are not as many formulas as coordinates.
    #[error("{what} needs {expected} formulas, one for each coordinate, and has {found}")]
    Count {
        /// What the formulas are for.
        what: String,
        /// The number of coordinates.
        expected: usize,
        /// The number of formulas.
        found: usize,
    },
    /// No coordinates have this name.
    #[error("{what} has no {name}: the coordinates are {}", names.join(", "))]
    NoCoordinate {
        /// What has the name.
        what: String,
        /// The name.
        name: String,
        /// The names of the coordinates.
        names: Vec<String>,
    },
    /// A torque acts on a direction, whose length has a meaning.
    #[error("a torque has formulas for {} alone: {name} is a direction in space", momenta.join(" and "))]
    TorqueOnDirection {
        /// The name of the direction.
        name: String,
        /// The names of the other coordinates.
        momenta: Vec<String>,
    },
    /// The matrix of an inner product is none, or is not as large as the algebra.
    #[error("the inner product: {0}")]
    InnerProduct(InnerProductError),
    /// The matrix of an inner product is not as large as the algebra.
    #[error("the inner product has {found} rows, and the algebra {expected} dimensions")]
    InnerProductSize {
        /// The dimension of the algebra.
        expected: usize,
        /// The number of rows.
        found: usize,
    },
    /// An inner product is missing where coordinates have different units.
    #[error(
        "an inner product is needed, a matrix of {dimension} rows or its diagonal: the vectors of coordinates {} may have \
         different units", vectors.join(", ")
    )]
    NoInnerProduct {
        /// The number of coordinates.
        dimension: usize,
        /// The names of the vectors of coordinates.
        vectors: Vec<String>,
    },
    /// A friction or a temperature is negative or no number.
    #[error(transparent)]
    Dissipation(#[from] DissipationError),
    /// The step or the bound of the noise is no positive number.
    #[error(transparent)]
    Brownian(#[from] BrownianError),
    /// The strength of a noise is negative or no number.
    #[error("the strength of the noise must be 0 or a positive number, it is {strength}")]
    Strength {
        /// The rejected strength.
        strength: f64,
    },
    /// A parameter or a coordinate has the name of the time.
    #[error("with forces the name `t` is that of the time: rename the parameter or the coordinate")]
    TimeName,
    /// The number of a path is beyond those that are told apart.
    #[error("the number of a path must be below {most}, it is {path}")]
    PathNumber {
        /// The rejected number.
        path: u64,
        /// The least number that is too large.
        most: u64,
    },
    /// An interval of the noise is so short that a step has too many of them.
    #[error("an interval of the noise must be at least {least}, it is {interval}")]
    ShortInterval {
        /// The rejected length.
        interval: f64,
        /// The least length, a ten-thousandth of a step.
        least: f64,
    },
    /// A temperature has no friction to which it belongs.
    #[error(
        "a temperature needs a friction: the strength of the noise is the root of 2 × friction × temperature"
    )]
    TemperatureAlone,
    /// A friction of 0 would make a temperature void.
    #[error(
        "beside temperature = {temperature} the friction must be a positive number, it is friction = 0: the strength of \
         the noise is the root of 2 × friction × temperature"
    )]
    TemperatureWithoutFriction {
        /// The temperature, which is positive.
        temperature: f64,
    },
    /// Steps would go back in time at a temperature.
    #[error(
        "a motion at a temperature has no way back in time, where its friction = {friction} would make it gain energy: steps must \
         be above 0, and with them the end; the step is {step}"
    )]
    BackAtTemperature {
        /// The friction, which is positive.
        friction: f64,
        /// The step, which is negative.
        step: f64,
    },
    /// A form of damping is of spins, and the coordinates are others.
    #[error(
        "a form of damping is of spins, on so(3) or a sum of several so(3): {algebra} has friction with inner_product, and \
         no form"
    )]
    NoSpins {
        /// The name of the algebra.
        algebra: String,
    },
}

impl OpenSystemError {
    /// Checks a friction, and the temperature kT beside it; 0 if there is none.
    ///
    /// # Errors
    /// Returns [`Dissipation`](Self::Dissipation) for a number that is negative or not finite, and
    /// [`TemperatureWithoutFriction`](Self::TemperatureWithoutFriction).
    pub fn require_thermal(friction: f64, temperature: f64) -> Result<(), Self> {
        DissipationError::require_friction(friction)?;
        DissipationError::require_temperature(temperature)?;
        if friction == 0.0 && temperature > 0.0 {
            return Err(Self::TemperatureWithoutFriction { temperature });
        }
        Ok(())
    }

    /// Checks that steps go forward in time where noise and friction are those of a temperature. Backward the friction would be
    /// negative, and the weight of states exp(+h/kT), if it had a sum.
    ///
    /// # Errors
    /// Returns [`BackAtTemperature`](Self::BackAtTemperature) for a step below 0.
    pub fn require_forward(friction: f64, step: f64) -> Result<(), Self> {
        match step < 0.0 {
            true => Err(Self::BackAtTemperature { friction, step }),
            false => Ok(()),
        }
    }
}

impl From<InnerProductError> for OpenSystemError {
    fn from(reason: InnerProductError) -> Self {
        Self::InnerProduct(reason)
    }
}
