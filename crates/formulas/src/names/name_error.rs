//! The error of names that cannot stand side by side in a formula: [`NameError`].

use thiserror::Error;

/// The reason why a name, or the number that it stands for, cannot be used in a formula.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum NameError {
    /// The text is not a letter followed by letters, digits and underscores.
    #[error("`{name}` is not a name: write a letter, then letters, digits or underscores")]
    NotAName {
        /// The text that is not a name.
        name: String,
    },
    /// The name is that of a function or of a constant.
    #[error("the name `{name}` is reserved: it is a function or a constant of formulas")]
    Reserved {
        /// The name that is reserved.
        name: String,
    },
    /// Two coordinates or parameters have the same name, or one is a component of the other.
    ///
    /// A vector `Pi` of dimension three takes the names `Pi`, `Pi1`, `Pi2` and `Pi3`.
    #[error("the name `{name}` stands for two things")]
    Repeated {
        /// The name that is defined twice.
        name: String,
    },
    /// A parameter is infinite or not a number.
    #[error("the parameter `{name}` is {value}, which is not a finite number")]
    NotFinite {
        /// The name of the parameter.
        name: String,
        /// The value that is not a finite number.
        value: f64,
    },
    /// A vector has no components, or more than a formula can have.
    #[error("the vector `{name}` has {dimension} components; it needs between 1 and {limit}")]
    Dimension {
        /// The name of the vector.
        name: String,
        /// The number of its components.
        dimension: usize,
        /// The largest number of components.
        limit: usize,
    },
    /// There are more coordinates than a formula can have.
    #[error("there are {count} coordinates; a formula has at most {limit}")]
    TooMany {
        /// The number of coordinates.
        count: usize,
        /// The largest number of coordinates.
        limit: usize,
    },
}
