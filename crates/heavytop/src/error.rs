//! Errors of the parameters of tops.

use thiserror::Error;

/// The reason why a set of parameters is not a heavy top.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TopError {
    /// A number is infinite or not a number.
    #[error("{name} must be a finite number, got {value:?}")]
    NotFinite {
        /// The name of the parameter.
        name: &'static str,
        /// The value of the parameter.
        value: f64,
    },
    /// A number is not positive.
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
    /// A number is outside its range.
    #[error("{name} must be from {least} to {greatest}, got {value}")]
    OutOfRange {
        /// The name of the parameter.
        name: &'static str,
        /// The value of the parameter.
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
        /// One of the other moments.
        first: f64,
        /// The remaining moment.
        second: f64,
    },
    /// The moments leave no room for the mass at its distance from the support.
    #[error(
        "no body has these moments about the support: with {:?} kg m² of the mass at the centre of mass taken off, \
         {:?}, {:?} and {:?} kg m² remain about the centre of mass",
        rounded(*point), rounded(*least), rounded(*middle), rounded(*greatest)
    )]
    ImpossibleBody {
        /// The moment m l² of the mass at the centre of mass, kg m².
        point: f64,
        /// The least principal moment about the centre of mass, kg m².
        least: f64,
        /// The middle principal moment about the centre of mass, kg m².
        middle: f64,
        /// The greatest principal moment about the centre of mass, kg m².
        greatest: f64,
    },
    /// An inertia matrix is not symmetric.
    #[error(
        "inertia must be symmetric: inertia[{row}][{column}] = {value:?}, but inertia[{column}][{row}] = {mirrored:?}"
    )]
    NotSymmetric {
        /// The row of an entry, from 0.
        row: usize,
        /// The column of the entry, from 0.
        column: usize,
        /// The entry.
        value: f64,
        /// The entry with row and column exchanged.
        mirrored: f64,
    },
    /// The centre of mass of a thin rod is off the rod.
    #[error(
        "inertia[{axis}] = 0 is a thin rod, whose centre of mass lies on it, but center_of_mass is {across:?} away from it"
    )]
    RodCenter {
        /// The principal axis of the rod: 0, 1 or 2.
        axis: usize,
        /// The part of the unit vector c at right angles to the rod.
        across: f64,
    },
    /// A thin rod has an angular momentum about its own axis.
    #[error(
        "inertia[{axis}] = 0 is a thin rod, which has no angular momentum about itself, got {momentum:?} kg m²/s"
    )]
    RodSpin {
        /// The principal axis of the rod: 0, 1 or 2.
        axis: usize,
        /// The angular momentum about the axis, kg m²/s.
        momentum: f64,
    },
    /// The top is not Lagrange's, which the closed form requires.
    #[error("the top must be Lagrange's: I₁ = I₂, centre of mass on +e₃, gravity at work")]
    NotLagrange,
    /// The top is not symmetric about e₃.
    #[error("the top must be symmetric about e₃: I₁ = {first:?} is not I₂ = {second:?}")]
    NotSymmetricTop {
        /// The moment of inertia I₁.
        first: f64,
        /// The moment of inertia I₂.
        second: f64,
    },
    /// A direction is not a unit vector.
    #[error("{name} must be a unit vector to within {tolerance:e}, its length is {length:?}")]
    NotUnit {
        /// The name of the parameter.
        name: &'static str,
        /// The length of the vector.
        length: f64,
        /// The largest difference of the length from 1.
        tolerance: f64,
    },
}

/// The largest difference of the length of a unit vector from 1.
pub const UNIT_TOLERANCE: f64 = 1e-9;

/// Checks that `direction` is a unit vector, to within [`UNIT_TOLERANCE`].
///
/// # Errors
/// Returns [`TopError::NotUnit`] if the vector is longer or shorter, or not finite. The error names the
/// parameter by `name`.
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

/// Returns a number without the digits that its computation has rounded.
fn rounded(x: f64) -> f64 {
    format!("{x:.12e}").parse().unwrap_or(x)
}
