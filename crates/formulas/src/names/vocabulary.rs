//! All names that a formula may use: [`Vocabulary`].

use super::coordinates::{Coordinates, component};
use super::name_error::NameError;
use super::named_algebra::NamedAlgebra;
use super::parameters::Parameters;
use std::collections::BTreeMap;

/// The meaning of a name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Meaning {
    /// The coordinate with an index.
    Coordinate(usize),
    /// The coordinates from an index on, as many as the dimension.
    Coordinates(usize, usize),
    /// The value of a parameter that is a number.
    Number(f64),
    /// The components of a parameter that is a vector.
    Numbers(Vec<f64>),
}

/// The names that a formula may use: coordinates and parameters.
///
/// # Example
/// ```
/// use lie_poisson::Se3;
/// use lie_poisson_formulas::{Coordinates, NameError, Parameters, Vocabulary};
/// // the coordinates Pi and Gamma of se(3)∗, and a number
/// let names = Vocabulary::of(&Se3::default(), &Parameters::new().number("mgl", 1.0)?)?;
/// assert_eq!(names.coordinates().dimension(), 6);
/// // a parameter cannot have the name of a coordinate
/// let clash = Vocabulary::of(&Se3::default(), &Parameters::new().number("Γ₁", 1.0)?);
/// assert_eq!(clash, Err(NameError::Repeated { name: "Gamma1".into() }));
/// # Ok::<(), NameError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Vocabulary {
    coordinates: Coordinates,
    meanings: BTreeMap<String, Meaning>,
}

impl Vocabulary {
    /// Creates the vocabulary of coordinates and parameters.
    ///
    /// # Errors
    /// Returns [`NameError::Repeated`] if two of them, or two components of their vectors, have the same name.
    pub fn new(coordinates: &Coordinates, parameters: &Parameters) -> Result<Self, NameError> {
        let mut all = Self { coordinates: coordinates.clone(), meanings: BTreeMap::new() };
        for field in coordinates.fields() {
            if let Some(dimension) = field.dimension {
                all.add(field.name.clone(), Meaning::Coordinates(field.start, dimension))?;
            }
            for (i, name) in field.names().enumerate() {
                all.add(name, Meaning::Coordinate(field.start + i))?;
            }
        }
        for parameter in parameters.entries() {
            if parameter.is_vector {
                all.add(parameter.name.clone(), Meaning::Numbers(parameter.values.clone()))?;
            }
            for (i, value) in parameter.values.iter().enumerate() {
                let one = || parameter.name.clone();
                let name = if parameter.is_vector { component(&one(), i) } else { one() };
                all.add(name, Meaning::Number(*value))?;
            }
        }
        Ok(all)
    }

    /// Creates the vocabulary of the coordinates of an algebra and of parameters.
    ///
    /// # Errors
    /// Returns [`NameError`] if two names are the same, or if there are too many coordinates.
    pub fn of<A: NamedAlgebra>(algebra: &A, parameters: &Parameters) -> Result<Self, NameError> {
        Self::new(&algebra.coordinates()?, parameters)
    }

    fn add(&mut self, name: String, meaning: Meaning) -> Result<(), NameError> {
        match self.meanings.insert(name.clone(), meaning) {
            Some(_) => Err(NameError::Repeated { name }),
            None => Ok(()),
        }
    }

    /// Returns the coordinates of this vocabulary.
    #[must_use]
    pub const fn coordinates(&self) -> &Coordinates {
        &self.coordinates
    }

    /// Returns the meaning of a name in plain letters. `S3` is `S_3` where there is no `S3`.
    pub(crate) fn meaning(&self, name: &str) -> Option<&Meaning> {
        self.meanings.get(name).or_else(|| {
            let symbol = name.trim_end_matches(|digit: char| digit.is_ascii_digit());
            let number = name.strip_prefix(symbol).filter(|number| !number.is_empty())?;
            self.meanings.get(&format!("{symbol}_{number}"))
        })
    }

    /// Returns the dimension of a vector of this name.
    pub(crate) fn dimension(&self, name: &str) -> Option<usize> {
        match self.meaning(name)? {
            Meaning::Coordinates(_, dimension) => Some(*dimension),
            Meaning::Numbers(values) => Some(values.len()),
            _ => None,
        }
    }

    /// Returns how many scalars have the name followed by 1, 2, ….
    pub(crate) fn numbered(&self, name: &str) -> usize {
        let is_scalar = |number: &usize| {
            let meaning = self.meanings.get(&format!("{name}{number}"));
            matches!(meaning, Some(Meaning::Coordinate(_) | Meaning::Number(_)))
        };
        (1..).take_while(is_scalar).count()
    }

    /// Returns all names, in alphabetical order.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.meanings.keys().map(String::as_str)
    }
}
