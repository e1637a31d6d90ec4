//! Why there is no such sweep.

use thiserror::Error;

/// A sweep that cannot be.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// There is nothing to vary.
    #[error("axes must have at least one axis")]
    NoAxes,
    /// There is nothing to find out.
    #[error("observables must name at least one")]
    NoObservables,
    /// An observable is named twice.
    #[error("observables must not name one twice")]
    Twice,
    /// An axis does not say how its values are chosen.
    #[error("the axis {parameter} needs {needs}")]
    Axis {
        /// Its parameter.
        parameter: &'static str,
        /// What it needs, and has.
        needs: String,
    },
    /// Two axes set the same number.
    #[error("the axes {first} and {second} set the same thing")]
    Clash {
        /// One parameter.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// Some axes are grids, others are random.
    #[error("the axes must be all grids or all random")]
    Mixed,
    /// Random axes without a number of tops, or grids with one.
    #[error("count is needed where the axes are random, and only there; at least 1")]
    Count,
    /// There are too many tops.
    #[error("the sweep has {tops:e} tops, more than {most:e}")]
    TooMany {
        /// How many.
        tops: f64,
        /// The most that there may be.
        most: f64,
    },
}
