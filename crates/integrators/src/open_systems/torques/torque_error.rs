//! The error of the numbers of a torque: [`TorqueError`].

use lie_poisson::State;
use thiserror::Error;

/// The reason why numbers are not those of a torque.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TorqueError {
    /// A coordinate of a constant torque is not a finite number.
    #[error("coordinate {coordinate} of the torque is {number}, which is not a finite number")]
    NotFinite {
        /// The coordinate, from 1.
        coordinate: usize,
        /// The number there.
        number: f64,
    },
    /// A rate of viscous friction is negative, infinite or NaN.
    #[error("a rate of friction is a finite number of at least 0, and rate {coordinate} is {rate}")]
    Rate {
        /// The coordinate, or the principal axis of a matrix in the order of increasing rates, from 1.
        coordinate: usize,
        /// The rate.
        rate: f64,
    },
    /// An entry of a matrix of friction is not a finite number.
    #[error(
        "the entry of friction in row {row} and column {column} is {number}, which is not a finite number"
    )]
    NotFiniteEntry {
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// The number there.
        number: f64,
    },
    /// A matrix of friction is not symmetric.
    #[error(
        "a matrix of friction is symmetric, and the entry in row {row} and column {column} is {entry}, the one across \
         the diagonal {across}"
    )]
    NotSymmetric {
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// The entry there.
        entry: f64,
        /// The entry with row and column exchanged.
        across: f64,
    },
}

/// Returns the first coordinate, from 1, that is not as required, and the number there.
pub(super) fn first_wrong<D: State<Scalar = f64>>(
    vector: &D,
    is_right: impl Fn(f64) -> bool,
) -> Option<(usize, f64)> {
    let numbers = (0..vector.dimension()).map(|i| (i + 1, vector.coordinate(i)));
    numbers.into_iter().find(|(_, number)| !is_right(*number))
}
