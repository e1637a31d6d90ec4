//! Lie algebras and parameters as Python passes them.

use crate::errors::refused;
use core::ops::Range;
use lie_poisson_formula_systems::{
    FormulaSystemError, QuadraticMomenta, SystemAlgebra, SystemKind, matrices_of_rows,
};
use lie_poisson_formulas::{Coordinates, NameError, Parameters, StructureEntry};
use pyo3::{FromPyObject, IntoPyObject, PyResult, pyfunction};

/// A parameter: its name, its numbers, and whether it is a vector.
pub(crate) type ParameterArgument = (String, Vec<f64>, bool);

/// A Lie algebra.
#[derive(Clone, FromPyObject, IntoPyObject)]
pub(crate) enum AlgebraSource {
    /// The name of a system of the library, whose algebra it is.
    OfKind((String,)),
    /// An expression.
    Named(String),
    /// An expression, and other symbols for its coordinates.
    Renamed(String, Vec<String>),
    /// An expression, symbols for its coordinates if there are any, and the representations that it names, by their rows.
    Represented(String, Vec<String>, Vec<(String, Matrices)>),
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
            Self::OfKind((name,)) => {
                let system = SystemKind::named(name).and_then(|kind| kind.system(parameters));
                system.map(|system| system.algebra().clone())
            }
            Self::Named(name) => SystemAlgebra::named(name),
            Self::Renamed(name, symbols) => {
                let symbols: Vec<&str> = symbols.iter().map(String::as_str).collect();
                SystemAlgebra::named(name).and_then(|algebra| algebra.with_symbols(&symbols))
            }
            Self::Represented(name, symbols, representations) => {
                let given = representations.iter();
                let given = given.map(|(name, rows)| Ok((name.clone(), matrices_of_rows(rows)?)));
                let given: Result<_, FormulaSystemError> = given.collect();
                let symbols: Vec<&str> = symbols.iter().map(String::as_str).collect();
                let named = given.and_then(|given| SystemAlgebra::named_with(name, &given));
                named.and_then(|named| match symbols.is_empty() {
                    true => Ok(named),
                    false => named.with_symbols(&symbols),
                })
            }
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

/// The matrices of a realisation by rows, and whether they are those of a representation. If not, they are those of quadratic
/// momenta.
pub(crate) type Realisation = (Matrices, bool);

/// Matrices by rows.
pub(crate) type Matrices = Vec<Vec<Vec<f64>>>;

/// Returns an algebra with momenta of its own.
pub(crate) fn realised(
    algebra: SystemAlgebra,
    (matrices, is_representation): &Realisation,
) -> PyResult<SystemAlgebra> {
    let momenta = QuadraticMomenta::of_rows(matrices, *is_representation);
    momenta.and_then(|momenta| algebra.with_realisation(momenta)).map_err(refused)
}

/// The names of the scalars and vectors of coordinates, with their dimensions; 0 for a scalar.
pub(crate) type Groups = Vec<(String, usize)>;

/// Returns the names and dimensions of the coordinates of an algebra.
pub(crate) fn groups(algebra: &SystemAlgebra) -> Groups {
    let coordinates = algebra.coordinates();
    let is_scalar = |name: &str| coordinates.names().any(|own| own == name);
    let group = |(name, places): (&str, Range<usize>)| {
        (name.to_owned(), if is_scalar(name) { 0 } else { places.len() })
    };
    coordinates.groups().map(group).collect()
}

/// Returns the names of the scalars and vectors of coordinates, with their dimensions; 0 for a scalar.
#[pyfunction]
pub fn coordinate_groups(
    algebra: AlgebraSource,
    arguments: Vec<ParameterArgument>,
) -> PyResult<Groups> {
    Ok(groups(&algebra.algebra(&parameters(&arguments)?)?))
}

/// Returns the coordinates of a start that a system of the library takes by other names, or `None` if these are not among
/// them.
#[pyfunction]
pub fn start_of_kind(
    name: &str,
    arguments: Vec<ParameterArgument>,
    given: Vec<ParameterArgument>,
) -> PyResult<Option<Vec<f64>>> {
    let kind = SystemKind::named(name).map_err(refused)?;
    let start = kind.coordinates(&parameters(&arguments)?, &parameters(&given)?);
    start.transpose().map_err(refused)
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
