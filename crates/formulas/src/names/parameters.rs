//! Named numbers and vectors of numbers: [`Parameters`].

use super::coordinates::{MOST_COORDINATES, checked};
use super::name_error::NameError;

/// The named numbers in a formula, such as moments of inertia, and named vectors of numbers.
///
/// # Example
/// ```
/// use lie_poisson_formulas::Parameters;
/// let parameters = Parameters::new().number("mgl", 1.5)?.vector("c", &[0.0, 0.0, 1.0])?;
/// assert!(parameters.clone().number("sin", 1.0).is_err()); // a function
/// assert!(parameters.number("I1", f64::NAN).is_err());
/// # Ok::<(), lie_poisson_formulas::NameError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parameters {
    entries: Vec<Parameter>,
}

/// A named number or vector.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Parameter {
    pub(crate) name: String,
    pub(crate) values: Vec<f64>,
    pub(crate) is_vector: bool,
}

impl Parameters {
    /// Creates an empty set of parameters.
    #[must_use]
    pub const fn new() -> Self {
        Self { entries: Vec::new() }
    }

    /// Adds a parameter that is a number.
    ///
    /// # Errors
    /// Returns [`NameError`] if the name is malformed, reserved or taken, or if the number is not finite.
    pub fn number(self, name: &str, value: f64) -> Result<Self, NameError> {
        self.with(name, vec![value], false)
    }

    /// Adds a parameter that is a vector, with the components `name1`, `name2` and so on.
    ///
    /// # Errors
    /// Returns [`NameError`] if the name is malformed, reserved or taken, if a component is not finite, or if there
    /// are no components or more than 256.
    pub fn vector(self, name: &str, values: &[f64]) -> Result<Self, NameError> {
        if values.is_empty() || values.len() > MOST_COORDINATES {
            let (name, dimension) = (name.to_owned(), values.len());
            return Err(NameError::Dimension { name, dimension, limit: MOST_COORDINATES });
        }
        self.with(name, values.to_vec(), true)
    }

    fn with(mut self, name: &str, values: Vec<f64>, is_vector: bool) -> Result<Self, NameError> {
        let name = checked(name)?;
        if let Some(&value) = values.iter().find(|value| !value.is_finite()) {
            return Err(NameError::NotFinite { name, value });
        }
        if self.entries.iter().any(|entry| entry.name == name) {
            return Err(NameError::Repeated { name });
        }
        self.entries.push(Parameter { name, values, is_vector });
        Ok(self)
    }

    /// Returns the names in the order in which they were added, with the number of components of each vector.
    pub fn shapes(&self) -> impl Iterator<Item = (&str, Option<usize>)> {
        let shape = |entry: &Parameter| entry.is_vector.then_some(entry.values.len());
        self.entries.iter().map(move |entry| (entry.name.as_str(), shape(entry)))
    }

    /// Returns the numbers of a parameter, one for a number.
    #[must_use]
    pub fn values(&self, name: &str) -> Option<&[f64]> {
        self.entries.iter().find(|entry| entry.name == name).map(|entry| entry.values.as_slice())
    }

    /// Returns the parameters in the order in which they were added.
    pub(crate) fn entries(&self) -> &[Parameter] {
        &self.entries
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_have_one_to_256_components() {
        let vector = |count: usize| Parameters::new().vector("a", &vec![1.0; count]);
        for count in [0, 257, 300, 1000] {
            let expected = NameError::Dimension { name: "a".into(), dimension: count, limit: 256 };
            assert_eq!(vector(count), Err(expected));
        }
        assert!(vector(1).is_ok() && vector(256).is_ok());
    }
}
