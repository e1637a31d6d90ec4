//! Formulas from Python: texts, and functions that were traced.

use lie_poisson_formulas::{
    Coordinates, Expression, Expressions, Formula, FormulaError, Vocabulary, names_in,
};
use pyo3::exceptions::PyValueError;
use pyo3::{FromPyObject, IntoPyObject, PyErr, PyResult};

/// A part of a traced function: an operation, a number, and the places of up to three parts before it.
///
/// The operations are `number`, `coordinate` with its index, `add`, `subtract`, `multiply`, `divide`, `power`, `negate`,
/// `abs`, `where`, and the functions of formulas by name.
pub(crate) type TracedPart = (String, f64, usize, usize, usize);

/// A scalar function of the state.
#[derive(Clone, FromPyObject, IntoPyObject)]
pub(crate) enum FormulaSource {
    /// A formula as text.
    Text(String),
    /// The parts of a traced function, of which the last is the value.
    Traced(Vec<TracedPart>),
}

impl FormulaSource {
    /// Returns the formula in some names.
    ///
    /// # Errors
    /// Returns `ValueError`, with the place in a text.
    pub(crate) fn formula(&self, names: &Vocabulary) -> PyResult<Formula> {
        match self {
            Self::Text(text) => Formula::new(text, names).map_err(|error| {
                PyValueError::new_err(format!("this is no formula:\n{}", error.quoted(text)))
            }),
            Self::Traced(parts) => {
                let (parts, value) = expressions(parts, names.coordinates())?;
                Formula::of_expressions(&parts, value, names).map_err(refused)
            }
        }
    }

    /// Returns whether the formula names something with a name, and a place among the coordinates, the time and the inputs. A formula
    /// such as `0*u` names u, too.
    pub(crate) fn names(&self, name: &str, place: usize) -> bool {
        match self {
            Self::Text(text) => {
                let all = names_in(text);
                names_in(name).iter().all(|name| all.contains(name))
            }
            Self::Traced(parts) => {
                parts.iter().any(|(what, _, first, ..)| what == "coordinate" && *first == place)
            }
        }
    }
}

/// Returns the expressions of a traced function, and its value.
pub(crate) fn expressions(
    parts: &[TracedPart],
    coordinates: &Coordinates,
) -> PyResult<(Expressions, Expression)> {
    let coordinates: Vec<String> = coordinates.names().collect();
    let (mut all, mut places) = (Expressions::new(), Vec::with_capacity(parts.len()));
    for (operation, number, first, second, third) in parts {
        let at = |place: &usize| places.get(*place).copied().ok_or_else(malformed);
        let place: Expression = match operation.as_str() {
            "number" => all.number(*number),
            "coordinate" => all.name(coordinates.get(*first).ok_or_else(malformed)?),
            "add" => all.add(at(first)?, at(second)?),
            "subtract" => all.subtract(at(first)?, at(second)?),
            "multiply" => all.multiply(at(first)?, at(second)?),
            "divide" => all.divide(at(first)?, at(second)?),
            "power" => all.power(at(first)?, at(second)?),
            "negate" => all.negate(at(first)?),
            "abs" => all.norm(at(first)?),
            "where" => all.choose(at(first)?, at(second)?, at(third)?),
            "atan2" => all.call("atan2", &[at(first)?, at(second)?]).map_err(refused)?,
            function => all.call(function, &[at(first)?]).map_err(refused)?,
        };
        places.push(place);
    }
    let value = places.last().copied().ok_or_else(malformed)?;
    Ok((all, value))
}

fn refused(error: FormulaError) -> PyErr {
    PyValueError::new_err(format!("the traced function: {error}"))
}

fn malformed() -> PyErr {
    PyValueError::new_err("the traced function refers to a part that it does not have")
}
