//! The error of a search for Casimirs: [`CasimirError`].

use crate::names::name_error::NameError;
use thiserror::Error;

/// The reason why a search for Casimirs is impossible: the names do not fit the algebra, or a structure constant is not
/// finite.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CasimirError {
    /// There are fewer or more names than dimensions.
    #[error("there are {names} names of coordinates for an algebra of dimension {dimension}")]
    WrongDimension {
        /// The number of names.
        names: usize,
        /// The dimension of the algebra.
        dimension: usize,
    },
    /// A structure constant is infinite or not a number.
    #[error("[e{i}, e{j}] has a coordinate that is not a finite number")]
    NotFinite {
        /// The first index of the bracket.
        i: usize,
        /// The second index of the bracket.
        j: usize,
    },
    /// The names cannot be those of a formula.
    #[error(transparent)]
    Name(#[from] NameError),
}
