//! Lie algebras and parameters as Python passes them.

use crate::errors::refused;
use core::ops::Range;
use lie_poisson_formula_systems::{SystemAlgebra, SystemKind};
use lie_poisson_formulas::{Coordinates, NameError, Parameters, StructureEntry};
use pyo3::{FromPyObject, IntoPyObject, PyResult, pyfunction};

/// A parameter: its name, its numbers, and whether it is a vector.
pub(crate) type ParameterArgument = (String, Vec<f64>, bool);

/// A Lie algebra.
#[derive(Clone, FromPyObject, IntoPyObject)]
pub(crate) enum AlgebraSource {
    /// The name of a system of the library, whose algebra it is.
    OfKind((String,)),
    /// The name of an algebra of the library.
    Named(String),
    /// The names of the coordinates, and the brackets of pairs of them that are not zero.
    Brackets(Vec<String>, Vec<(String, String)>),
    /// The names of the coordinates, or of one vector of them with its dimension, and the structure constants
    /// (i, j, k, c) that are not zero.
    Constants(CoordinateNames, Vec<(usize, usize, usize, f64)>, usize),
}

/// The names of coordinates.
#[derive(Clone, FromPyObject, IntoPyObject)]
pub(crate) enum CoordinateNames {
    /// A vector, whose components are the coordinates.
    Vector(String),
    /// The name of each coordinate.
    Scalars(Vec<String>),
}

impl AlgebraSource {
    /// Returns the algebra from this description.
    pub(crate) fn algebra(&self, parameters: &Parameters) -> PyResult<SystemAlgebra> {
        let scalars = |names: &[String]| Coordinates::scalars(names.iter().map(String::as_str));
        match self {
            Self::OfKind((name,)) => SystemKind::named(name).and_then(SystemKind::algebra),
            Self::Named(name) => SystemAlgebra::named(name),
            Self::Brackets(names, brackets) => {
                let coordinates = scalars(names).map_err(refused)?;
                let brackets = brackets.iter().map(|(pair, text)| (pair.as_str(), text.as_str()));
                SystemAlgebra::of_brackets(coordinates, brackets, parameters)
            }
            Self::Constants(names, constants, dimension) => {
                let coordinates = match names {
                    CoordinateNames::Vector(name) => Coordinates::new().vector(name, *dimension),
                    CoordinateNames::Scalars(names) => scalars(names),
                };
                let entries =
                    constants.iter().map(|&(i, j, k, value)| StructureEntry { i, j, k, value });
                SystemAlgebra::of_entries(coordinates.map_err(refused)?, entries.collect())
            }
        }
        .map_err(refused)
    }
}

/// Returns the names of the scalars and vectors of coordinates, with their dimensions; 0 for a scalar.
#[pyfunction]
pub fn coordinate_groups(
    algebra: AlgebraSource,
    arguments: Vec<ParameterArgument>,
) -> PyResult<Vec<(String, usize)>> {
    let algebra = algebra.algebra(&parameters(&arguments)?)?;
    let coordinates = algebra.coordinates();
    let is_scalar = |name: &str| coordinates.names().any(|own| own == name);
    let group = |(name, places): (&str, Range<usize>)| {
        (name.to_owned(), if is_scalar(name) { 0 } else { places.len() })
    };
    Ok(coordinates.groups().map(group).collect())
}

/// Returns the Hamiltonian of a system of the library.
#[pyfunction]
pub fn hamiltonian_of_kind(name: &str, arguments: Vec<ParameterArgument>) -> PyResult<String> {
    let kind = SystemKind::named(name).map_err(refused)?;
    kind.require_parameters(&parameters(&arguments)?).map_err(refused)?;
    Ok(kind.hamiltonian.into())
}

/// Returns the parameters from the arguments.
pub(crate) fn parameters(arguments: &[ParameterArgument]) -> PyResult<Parameters> {
    let add = |all: Parameters, (name, values, is_vector): &ParameterArgument| match (
        values.as_slice(),
        is_vector,
    ) {
        (&[value], false) => all.number(name, value),
        (values, _) => all.vector(name, values),
    };
    let all: Result<Parameters, NameError> = arguments.iter().try_fold(Parameters::new(), add);
    all.map_err(refused)
}
