//! The numbers of a system that the axes of a sweep vary.

use super::family::require_apart;
use crate::configuration::{
    Numbers, Parameter, SweepAxis, SystemConfig, SystemParameter, SystemTable,
};
use crate::errors::SweepError;
use crate::pictures::caption::{number, vector_of};
use crate::pictures::symbols::symbol;
use crate::vocabulary::suggestion::suggestion;
use lie_poisson_formulas::Coordinates;
use std::collections::BTreeMap;

/// The place of a number in the table `[system]`, or in the initial state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum VariedNumber {
    /// A number of `[system.parameters]`, with its index in a vector.
    Parameter(String, Option<usize>),
    /// A number of `[system.initial]` that is no coordinate, such as a position, with its index in a vector.
    Start(String, Option<usize>),
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
        coordinates: Option<&Coordinates>,
    ) -> Result<Self, SweepError> {
        let SystemParameter { table: kind, name, index } = parameter;
        if *kind == SystemTable::Parameters {
            let numbers = table.parameters.get(name).ok_or_else(|| {
                missing(parameter, table.parameters.keys().cloned(), "system.parameters has")
            })?;
            require_index(parameter, components(numbers))?;
            return Ok(Self::Parameter(name.clone(), *index));
        }
        if let Some(places) = coordinates.and_then(|coordinates| coordinates.places(name)) {
            require_index(parameter, Some(places.len()).filter(|count| *count > 1))?;
            return Ok(Self::Coordinate(places.start + index.unwrap_or(0)));
        }
        if let Some(numbers) = table.initial.get(name) {
            require_index(parameter, components(numbers))?;
            return Ok(Self::Start(name.clone(), *index));
        }
        Err(match coordinates {
            Some(all) => missing(parameter, all.names(), "the coordinates are"),
            None => missing(parameter, table.initial.keys().cloned(), "system.initial has"),
        })
    }

    /// Returns the name of the parameter whose number this is.
    pub fn parameter(&self) -> Option<&str> {
        match self {
            Self::Parameter(name, _) => Some(name),
            Self::Start(..) | Self::Coordinate(_) => None,
        }
    }

    /// Sets the number to a value.
    pub fn set(&self, value: f64, table: &mut SystemConfig, start: &mut [f64]) {
        let (numbers, index) = match self {
            Self::Coordinate(place) => {
                return start.get_mut(*place).into_iter().for_each(|number| *number = value);
            }
            Self::Parameter(name, index) => (table.parameters.get_mut(name), index),
            Self::Start(name, index) => (table.initial.get_mut(name), index),
        };
        let number = match (numbers, index) {
            (Some(Numbers::One(number)), _) => Some(number),
            (Some(Numbers::Many(values)), Some(index)) => values.get_mut(*index),
            _ => None,
        };
        number.into_iter().for_each(|number| *number = value);
    }

    /// Returns the name of the number in formulas, and "(0)" after a coordinate of the initial state.
    pub fn label(&self, coordinates: Option<&Coordinates>) -> String {
        match self {
            Self::Start(name, None) => symbol(name) + "(0)",
            Self::Start(name, Some(index)) => component(name, *index) + "(0)",
            Self::Parameter(name, None) => symbol(name),
            Self::Parameter(name, Some(index)) => component(name, *index),
            Self::Coordinate(place) => {
                let name = coordinates.and_then(|coordinates| coordinates.names().nth(*place));
                symbol(&name.unwrap_or_default()) + "(0)"
            }
        }
    }
}

/// The number that each axis of a sweep varies.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct VariedNumbers(Vec<VariedNumber>);

impl VariedNumbers {
    /// Finds the numbers of the axes.
    ///
    /// # Errors
    /// If an axis varies no number of the system, or two axes vary the same.
    pub fn of(
        axes: &[SweepAxis],
        table: &SystemConfig,
        coordinates: Option<&Coordinates>,
    ) -> Result<Self, SweepError> {
        let of_axis = |axis: &SweepAxis| match &axis.parameter {
            Parameter::System(parameter) => VariedNumber::of(parameter, table, coordinates),
            other => Err(SweepError::OfAnother {
                parameter: other.name(),
                of: other.table(),
                has: "vary system.parameters.NAME or system.initial.NAME".into(),
            }),
        };
        let numbers = axes.iter().map(of_axis).collect::<Result<Vec<_>, _>>()?;
        require_apart(axes, &numbers, |one, other| one == other)?;
        Ok(Self(numbers))
    }

    /// Returns the number of each axis.
    pub fn iter(&self) -> impl Iterator<Item = &VariedNumber> {
        self.0.iter()
    }

    /// Returns whether an axis varies this number.
    pub fn contain(&self, number: &VariedNumber) -> bool {
        self.0.contains(number)
    }

    /// Sets the numbers to these values.
    pub fn set(&self, values: &[f64], table: &mut SystemConfig, start: &mut [f64]) {
        self.0.iter().zip(values).for_each(|(varied, value)| varied.set(*value, table, start));
    }

    /// Returns the name of each number, as [`VariedNumber::label`].
    pub fn labels(&self, coordinates: Option<&Coordinates>) -> Vec<String> {
        self.0.iter().map(|varied| varied.label(coordinates)).collect()
    }

    /// Returns the parameters that all members share, in the words of a caption.
    pub fn shared_parameters(&self, table: &SystemConfig) -> Vec<String> {
        shared_numbers(&table.parameters, "", |name, index| {
            self.contain(&VariedNumber::Parameter(name.into(), index))
        })
    }

    /// Returns what all members share of `[system.initial]`, in the words of a caption.
    pub fn shared_start(&self, table: &SystemConfig) -> Vec<String> {
        shared_numbers(&table.initial, "(0)", |name, index| {
            self.contain(&VariedNumber::Start(name.into(), index))
        })
    }
}

/// Returns the number of components of a list, and `None` for a number.
fn components(numbers: &Numbers) -> Option<usize> {
    match numbers {
        Numbers::One(_) => None,
        Numbers::Many(values) => Some(values.len()),
    }
}

/// Returns the numbers of `[system.parameters]`, or of `[system.initial]` with "(0)", that all members share, in the words of
/// a caption; of long lists only how many numbers they have.
fn shared_numbers(
    numbers: &BTreeMap<String, Numbers>,
    suffix: &str,
    is_varied: impl Fn(&str, Option<usize>) -> bool,
) -> Vec<String> {
    let words = |(name, numbers): (&String, &Numbers)| {
        let varied = |i| is_varied(name, Some(i)).then(|| component(name, i));
        let is_alone_varied = is_varied(name, None);
        let name = symbol(name);
        match numbers {
            Numbers::One(_) if is_alone_varied => None,
            Numbers::One(value) => Some(format!("{name}{suffix} = {}", number(*value))),
            Numbers::Many(values) if values.len() > MOST_COMPONENTS => {
                Some(format!("{name}{suffix}: {} numbers", values.len()))
            }
            Numbers::Many(values) => vector_of(&format!("{name}{suffix}"), values, varied),
        }
    };
    numbers.iter().filter_map(words).collect()
}

/// The largest number of components that a caption shows.
const MOST_COMPONENTS: usize = 12;

/// Returns the symbol of a component of a vector.
pub(super) fn component(name: &str, index: usize) -> String {
    let names = Coordinates::new().vector(name, index + 1).ok();
    let last = names.and_then(|names| names.names().last());
    last.map_or_else(|| format!("{}[{index}]", symbol(name)), |name| symbol(&name))
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
