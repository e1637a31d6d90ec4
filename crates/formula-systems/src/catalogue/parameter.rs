//! The parameters of systems by name: [`Parameter`].

use crate::error::FormulaSystemError;
use lie_poisson_formulas::closest_name;

/// A parameter of a system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// The name in the Hamiltonian.
    pub name: &'static str,
    /// Whether it is a number, or how many numbers it is.
    pub shape: ParameterShape,
    /// What it is, with its unit.
    pub about: &'static str,
    /// The numbers that it is unless others are given; `None` if it must be given.
    pub default: Option<&'static [f64]>,
}

/// Whether a parameter is a number or a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterShape {
    /// One number.
    Number,
    /// A vector of so many numbers.
    Vector(usize),
    /// As many numbers as are given.
    List,
    /// One number, or as many as are given.
    NumberOrList,
}

/// Checks that parameters by name, each a number, for `None`, or so many numbers, are those of a kind of system, or those of
/// its start.
///
/// # Errors
/// Returns [`FormulaSystemError::KindParameter`] for the first one that is missing, has another shape or does not exist.
///
/// # Example
/// ```
/// use lie_poisson_formula_systems::{Parameter, require_parameters};
/// const ALL: &[Parameter] = &[Parameter::vector("field", 3, "B"), Parameter::number("exchange", "J").or(&[0.0])];
/// assert!(require_parameters(("spins", false), ALL, &[("field", Some(3))]).is_ok());
/// let error = require_parameters(("spins", false), ALL, &[("field", Some(3)), ("exchagne", None)]).unwrap_err();
/// assert!(error.to_string().starts_with("spins: there is no exchagne; did you mean exchange? It takes field"));
/// ```
pub fn require_parameters(
    (kind, is_start): (&'static str, bool),
    all: &'static [Parameter],
    given: &[(&str, Option<usize>)],
) -> Result<(), FormulaSystemError> {
    let wrong = |name: &str, problem: String| FormulaSystemError::KindParameter {
        kind,
        is_start,
        name: name.to_owned(),
        problem,
        has: all.iter().map(Parameter::described).collect(),
    };
    let is_own = |name: &str| all.iter().any(|own| own.name == name);
    if let Some((name, _)) = given.iter().find(|(name, _)| !is_own(name)) {
        let near = closest_name(name, all.iter().map(|own| own.name));
        let near = near.map_or_else(String::new, |near| format!("; did you mean {near}?"));
        return Err(wrong(name, format!("there is no {name}{near}")));
    }
    for own in all {
        let found = given.iter().find(|(name, _)| *name == own.name);
        match found {
            None if own.default.is_none() => {
                return Err(wrong(own.name, format!("{} is missing", own.name)));
            }
            Some((name, found)) if !own.shape.allows(*found) => {
                let (needed, found) = (own.shape.words(), words(*found));
                return Err(wrong(name, format!("{name} must be {needed}, got {found}")));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Returns a number of components in words.
fn words(components: Option<usize>) -> String {
    components.map_or("one number".into(), |count| format!("a list of {count}"))
}

impl ParameterShape {
    /// Returns what a value must be, in words.
    fn words(self) -> String {
        match self {
            Self::Number => words(None),
            Self::Vector(count) => words(Some(count)),
            Self::List => "a list of numbers".into(),
            Self::NumberOrList => "a number or a list of numbers".into(),
        }
    }

    /// Returns whether a parameter may be a number, for `None`, or a vector of so many components.
    #[must_use]
    pub fn allows(self, components: Option<usize>) -> bool {
        match self {
            Self::Number => components.is_none(),
            Self::Vector(count) => components == Some(count),
            Self::List => components.is_some(),
            Self::NumberOrList => true,
        }
    }
}

impl Parameter {
    const fn new(name: &'static str, shape: ParameterShape, about: &'static str) -> Self {
        Self { name, shape, about, default: None }
    }

    /// A number that must be given.
    #[must_use]
    pub const fn number(name: &'static str, about: &'static str) -> Self {
        Self::new(name, ParameterShape::Number, about)
    }

    /// A vector that must be given.
    #[must_use]
    pub const fn vector(name: &'static str, count: usize, about: &'static str) -> Self {
        Self::new(name, ParameterShape::Vector(count), about)
    }

    /// Numbers that must be given, as many as there are.
    #[must_use]
    pub const fn list(name: &'static str, about: &'static str) -> Self {
        Self::new(name, ParameterShape::List, about)
    }

    /// One number or several, which must be given.
    #[must_use]
    pub const fn number_or_list(name: &'static str, about: &'static str) -> Self {
        Self::new(name, ParameterShape::NumberOrList, about)
    }

    /// The parameter with values that it has unless others are given.
    #[must_use]
    pub const fn or(self, default: &'static [f64]) -> Self {
        Self { default: Some(default), ..self }
    }

    /// Describes the parameter: its name, how many numbers it is, what it is, and what it is unless given.
    #[must_use]
    pub fn described(&self) -> String {
        let Self { name, shape, about, default } = self;
        let shape = match shape {
            ParameterShape::Number => String::new(),
            ParameterShape::Vector(count) => format!(" of {count} numbers"),
            ParameterShape::List => " of any number of numbers".into(),
            ParameterShape::NumberOrList => ", a number or several".into(),
        };
        let default = match default {
            None => String::new(),
            Some([value]) => format!("; {value} unless given"),
            Some([]) => "; none unless given".into(),
            Some(values) => format!("; {values:?} unless given"),
        };
        format!("{name}{shape} ({about}{default})")
    }
}
