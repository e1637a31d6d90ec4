//! Errors of sweeps: why a configuration describes no sweep.

use thiserror::Error;

/// The reason why a configuration describes no sweep.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The sweep has no axes.
    #[error("axes must have at least one axis")]
    NoAxes,
    /// The sweep has no observables.
    #[error("observables must name at least one")]
    NoObservables,
    /// An observable is named twice.
    #[error("observables must not name one twice")]
    Twice,
    /// An axis does not say how its values are chosen.
    #[error("the axis {parameter} needs {needs}")]
    Axis {
        /// The parameter of the axis.
        parameter: &'static str,
        /// The keys that the axis needs, and those that it has.
        needs: String,
    },
    /// Two axes set the same number.
    #[error("the axes {first} and {second} set the same thing")]
    Clash {
        /// The parameter of the first axis.
        first: &'static str,
        /// The parameter of the second axis.
        second: &'static str,
    },
    /// An axis sets the angular momentum of a configuration that gives the angular velocity.
    #[error("the axis {axis} needs [initial] angular_momentum instead of angular_velocity")]
    Velocity {
        /// The parameter of the axis.
        axis: &'static str,
    },
    /// Some axes are grids, others are random.
    #[error("the axes must be all grids or all random")]
    Mixed,
    /// The axes are random and the number of tops is missing, or the axes are grids and it is given.
    #[error("count is needed where the axes are random, and only there; at least 1")]
    Count,
    /// There are too many tops.
    #[error("the sweep has {tops:e} tops, more than {most:e}")]
    TooMany {
        /// The number of tops.
        tops: f64,
        /// The largest number of tops allowed.
        most: f64,
    },
}
