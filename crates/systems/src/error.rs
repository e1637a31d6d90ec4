//! Errors of the parameters of systems.

use thiserror::Error;

/// The reason why parameters do not define a system of this crate.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SystemError {
    /// A number is infinite or not a number.
    #[error("{name} must be a finite number, got {value:?}")]
    NotFinite {
        /// The name of the parameter.
        name: &'static str,
        /// The value of the parameter.
        value: f64,
    },
    /// A number is not above zero.
    #[error("{name} must be positive, got {value:?}")]
    NotPositive {
        /// The name of the parameter.
        name: &'static str,
        /// The value of the parameter.
        value: f64,
    },
    /// A number is below zero.
    #[error("{name} must not be negative, got {value:?}")]
    Negative {
        /// The name of the parameter.
        name: &'static str,
        /// The value of the parameter.
        value: f64,
    },
    /// A number is too small or too large.
    #[error("{name} must be between {least:e} and {most:e}, got {value:?}")]
    OutOfRange {
        /// The name of the parameter.
        name: &'static str,
        /// The value of the parameter.
        value: f64,
        /// The least value allowed.
        least: f64,
        /// The largest value allowed.
        most: f64,
    },
    /// A number is zero.
    #[error("{name} must not be zero")]
    Zero {
        /// The name of the parameter.
        name: &'static str,
    },
    /// The number of parts is larger than the machine can represent.
    #[error("there are more {name} than the {} of this machine", usize::MAX)]
    TooMany {
        /// The name of the parts.
        name: &'static str,
    },
    /// The number of values is not the required one, or is below the least one.
    #[error("{expected} {name} are needed, got {found}")]
    Count {
        /// The name of the values.
        name: &'static str,
        /// The number that is needed, or the least number.
        expected: usize,
        /// The number that was given.
        found: usize,
    },
    /// A matrix is not symmetric.
    #[error(
        "{name} must be symmetric to within {tolerance:e} of its largest entry, it differs from its \
         transpose by {defect:e}"
    )]
    NotSymmetric {
        /// The name of the matrix.
        name: &'static str,
        /// The largest difference from the transpose.
        defect: f64,
        /// The largest difference allowed, relative to the largest entry.
        tolerance: f64,
    },
    /// No mass distribution has these principal moments.
    #[error(
        "principal moments must obey the triangle inequality: {largest:?} is more than \
         {first:?} + {second:?}"
    )]
    Triangle {
        /// The largest moment.
        largest: f64,
        /// One of the other moments.
        first: f64,
        /// The remaining moment.
        second: f64,
    },
}

pub(crate) fn require_positive(name: &'static str, value: f64) -> Result<(), SystemError> {
    require_finite(name, value)?;
    if value > 0.0 { Ok(()) } else { Err(SystemError::NotPositive { name, value }) }
}

pub(crate) fn require_not_negative(name: &'static str, value: f64) -> Result<(), SystemError> {
    require_finite(name, value)?;
    if value < 0.0 { Err(SystemError::Negative { name, value }) } else { Ok(()) }
}

pub(crate) fn require_within(
    name: &'static str,
    value: f64,
    [least, most]: [f64; 2],
) -> Result<(), SystemError> {
    let error = SystemError::OutOfRange { name, value, least, most };
    if least <= value && value <= most { Ok(()) } else { Err(error) }
}

pub(crate) fn require_finite(name: &'static str, value: f64) -> Result<(), SystemError> {
    if value.is_finite() { Ok(()) } else { Err(SystemError::NotFinite { name, value }) }
}
