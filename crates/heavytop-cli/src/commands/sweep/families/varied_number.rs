//! The number of a system that an axis of a sweep varies.

use crate::configuration::{Numbers, SystemConfig, SystemParameter, SystemTable};
use crate::errors::SweepError;
use crate::vocabulary::suggestion::suggestion;
use lie_poisson_formulas::Coordinates;

/// The place of a number in the table `[system]`, or in the initial state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum VariedNumber {
    /// A number of `[system.parameters]`, with its index in a vector.
    Parameter(String, Option<usize>),
    /// The coordinate of the initial state with this index.
    Coordinate(usize),
}

impl VariedNumber {
    /// Finds the number of a parameter.
    ///
    /// # Errors
    /// If there is no such number.
    pub fn of(
        parameter: &SystemParameter,
        table: &SystemConfig,
        coordinates: &Coordinates,
    ) -> Result<Self, SweepError> {
        let SystemParameter { table: kind, name, index } = parameter;
        match kind {
            SystemTable::Parameters => {
                let numbers = table.parameters.get(name).ok_or_else(|| {
                    missing(parameter, table.parameters.keys().cloned(), "system.parameters has")
                })?;
                let components = match numbers {
                    Numbers::One(_) => None,
                    Numbers::Many(values) => Some(values.len()),
                };
                require_index(parameter, components)?;
                Ok(Self::Parameter(name.clone(), *index))
            }
            SystemTable::Initial => {
                let places = coordinates.places(name).ok_or_else(|| {
                    missing(parameter, coordinates.names(), "the coordinates are")
                })?;
                require_index(parameter, Some(places.len()).filter(|count| *count > 1))?;
                Ok(Self::Coordinate(places.start + index.unwrap_or(0)))
            }
        }
    }

    /// Returns the name of the parameter whose number this is.
    pub fn parameter(&self) -> Option<&str> {
        match self {
            Self::Parameter(name, _) => Some(name),
            Self::Coordinate(_) => None,
        }
    }

    /// Sets the number to a value.
    pub fn set(&self, value: f64, table: &mut SystemConfig, start: &mut [f64]) {
        let number = match self {
            Self::Coordinate(place) => start.get_mut(*place),
            Self::Parameter(name, index) => match (table.parameters.get_mut(name), index) {
                (Some(Numbers::One(number)), _) => Some(number),
                (Some(Numbers::Many(values)), Some(index)) => values.get_mut(*index),
                _ => None,
            },
        };
        number.into_iter().for_each(|number| *number = value);
    }

    /// Returns the name of the number in formulas, and "(0)" after a coordinate of the initial state.
    pub fn label(&self, coordinates: &Coordinates) -> String {
        match self {
            Self::Parameter(name, None) => name.clone(),
            Self::Parameter(name, Some(index)) => component(name, *index),
            Self::Coordinate(place) => coordinates.names().nth(*place).unwrap_or_default() + "(0)",
        }
    }
}

/// Returns the name of a component of a vector in formulas.
pub(super) fn component(name: &str, index: usize) -> String {
    let names = Coordinates::new().vector(name, index + 1).ok();
    let last = names.and_then(|names| names.names().last());
    last.unwrap_or_else(|| format!("{name}[{index}]"))
}

/// Checks that a number of a vector has its index, and that another number has none.
fn require_index(parameter: &SystemParameter, components: Option<usize>) -> Result<(), SweepError> {
    let (parameter, index) = (parameter.to_string(), parameter.index);
    match (components, index) {
        (None, None) => Ok(()),
        (None, Some(_)) => Err(SweepError::NoVector { parameter }),
        (Some(count), Some(index)) if index < count => Ok(()),
        (Some(count), _) => {
            Err(SweepError::Index { parameter, index, most: count.saturating_sub(1) })
        }
    }
}

/// Returns the error that a table has no such name, with those that it has.
fn missing(
    parameter: &SystemParameter,
    names: impl Iterator<Item = String>,
    there: &str,
) -> SweepError {
    let names: Vec<String> = names.collect();
    let suggested = suggestion(&parameter.name, names.iter().map(String::as_str));
    let has = match names.as_slice() {
        [] => format!("{there} nothing"),
        names => format!("{there} {}{suggested}", names.join(", ")),
    };
    SweepError::NoParameter { parameter: parameter.to_string(), has }
}
