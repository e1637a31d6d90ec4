//! Parameters that no top has.

use thiserror::Error;

/// Why a set of parameters is not a heavy top.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TopError {
    /// A number is infinite or not a number.
    #[error("{name} must be a finite number, got {value:?}")]
    NotFinite {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number is not above its bound.
    #[error("{name} must be positive, got {value:?}")]
    NotPositive {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number is below zero.
    #[error("{name} must not be negative, got {value:?}")]
    Negative {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number is outside its range.
    #[error("{name} must be from {least} to {greatest}, got {value}")]
    OutOfRange {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The lower bound.
        least: f64,
        /// The upper bound.
        greatest: f64,
    },
    /// No mass distribution has these principal moments.
    #[error(
        "principal moments must obey the triangle inequality: {largest:?} is more than \
         {first:?} + {second:?}"
    )]
    Triangle {
        /// The largest moment.
        largest: f64,
        /// Another moment.
        first: f64,
        /// The remaining moment.
        second: f64,
    },
    /// The closed form asked for is that of another top.
    #[error("the top must be Lagrange's: I₁ = I₂, centre of mass on +e₃, gravity at work")]
    NotLagrange,
    /// The top has no axis of symmetry e₃.
    #[error("the top must be symmetric about e₃: I₁ = {first:?} is not I₂ = {second:?}")]
    NotSymmetricTop {
        /// I₁
        first: f64,
        /// I₂
        second: f64,
    },
    /// A direction is not a unit vector.
    #[error("{name} must be a unit vector to within {tolerance:e}, its length is {length:?}")]
    NotUnit {
        /// The parameter.
        name: &'static str,
        /// Its length.
        length: f64,
        /// How far the length may be from 1.
        tolerance: f64,
    },
}

/// How far the length of a direction may be from 1.
pub const UNIT_TOLERANCE: f64 = 1e-9;

/// Checks that `direction` is a unit vector, to within [`UNIT_TOLERANCE`].
///
/// # Errors
/// If it is not, or not finite; the error names the parameter by `name`.
pub fn require_unit(
    name: &'static str,
    direction: &nalgebra::Vector3<f64>,
) -> Result<(), TopError> {
    let length = direction.norm();
    if (length - 1.0).abs() <= UNIT_TOLERANCE {
        Ok(())
    } else {
        Err(TopError::NotUnit { name, length, tolerance: UNIT_TOLERANCE })
    }
}

pub(crate) fn require_positive(name: &'static str, value: f64) -> Result<(), TopError> {
    require_not_negative(name, value)?;
    if value > 0.0 { Ok(()) } else { Err(TopError::NotPositive { name, value }) }
}

pub(crate) fn require_not_negative(name: &'static str, value: f64) -> Result<(), TopError> {
    require_finite(name, value)?;
    if value < 0.0 { Err(TopError::Negative { name, value }) } else { Ok(()) }
}

pub(crate) fn require_finite(name: &'static str, value: f64) -> Result<(), TopError> {
    if value.is_finite() { Ok(()) } else { Err(TopError::NotFinite { name, value }) }
}
