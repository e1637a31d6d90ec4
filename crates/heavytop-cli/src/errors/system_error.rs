//! Errors of `[system]`: why a configuration describes no Lie–Poisson system.

use heavytop::methods::{Formulation, Scheme};
use lie_poisson_formulas::{CasimirError, EntryError, FormulaError, NameError};
use thiserror::Error;

/// The reason why a configuration describes no Lie–Poisson system.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SystemError {
    /// A command for tops got a system.
    #[error("only simulate runs a system; the other commands are for tops")]
    OnlySimulate,
    /// A table of tops stands beside the system.
    #[error("a system has no [{0}], which is of tops: its keys are in [system]")]
    Top(&'static str),
    /// A key is missing.
    #[error("{0} is missing")]
    Missing(&'static str),
    /// There is both a named algebra and a table of brackets.
    #[error("algebra excludes coordinates and brackets: write the one or the others")]
    TwoAlgebras,
    /// No algebra has this name.
    #[error("there is no algebra {name}; there are {}", names.join(", "))]
    NoAlgebra {
        /// The name.
        name: String,
        /// The names of all algebras.
        names: Vec<&'static str>,
    },
    /// The table has no coordinates, or too many.
    #[error("a system has 1 to {most} coordinates, not {count}")]
    Dimension {
        /// The number of coordinates.
        count: usize,
        /// The largest number of coordinates.
        most: usize,
    },
    /// The key of a bracket is not a pair of coordinates.
    #[error("brackets: `{key}` is not a pair of coordinates such as \"x, y\"")]
    NoPair {
        /// The key.
        key: String,
    },
    /// A bracket is not a linear combination of the coordinates.
    #[error("{key}: a bracket is a sum of multiples of coordinates, such as 2*x - y")]
    NotLinear {
        /// The key of the bracket.
        key: String,
    },
    /// The brackets are not those of a Lie algebra.
    #[error("brackets, numbered from 0 in the order of their keys")]
    Brackets(#[source] EntryError),
    /// A text is no formula.
    #[error("{key}")]
    Formula {
        /// The key of the text.
        key: String,
        /// What is wrong, and where in the text.
        source: FormulaError,
    },
    /// A name cannot be that of a coordinate or of a parameter.
    #[error("{key}")]
    Name {
        /// The key.
        key: String,
        /// What is wrong.
        source: NameError,
    },
    /// The Casimirs cannot be looked for.
    #[error("brackets")]
    Casimirs(#[from] CasimirError),
    /// A coordinate has no initial value.
    #[error("initial has no value for {names}")]
    NoValue {
        /// The names of the coordinates.
        names: String,
    },
    /// The initial values are of something else than coordinates.
    #[error("initial.{name} is not a coordinate; there are {names}")]
    NoCoordinate {
        /// The key.
        name: String,
        /// The names of the coordinates.
        names: String,
    },
    /// An initial value has the wrong number of components, or is not finite.
    #[error("initial.{name} needs {needed}")]
    WrongValue {
        /// The name of the coordinates.
        name: String,
        /// What it needs.
        needed: String,
    },
    /// The formulation does not exist for the algebra, or not with the scheme.
    #[error(
        "{algebra} has no {} {}; {has}",
        formulation.name(), scheme.name()
    )]
    NoMethod {
        /// The name of the algebra.
        algebra: String,
        /// The formulation.
        formulation: Formulation,
        /// The scheme.
        scheme: Scheme,
        /// The formulations and schemes that there are.
        has: String,
    },
    /// The attitude of a system that is no body is asked for.
    #[error("a system has no attitude")]
    NoAttitude,
}

impl SystemError {
    /// Returns the key at fault, below `[system]`, with what to write there.
    #[must_use]
    pub fn key(&self) -> Option<(String, &'static str)> {
        let (key, note) = match self {
            Self::OnlySimulate => (String::new(), "use simulate"),
            Self::Missing(_) => (String::new(), "add the key"),
            Self::Top(_) => return None,
            Self::TwoAlgebras | Self::NoAlgebra { .. } => ("algebra".into(), ""),
            Self::Dimension { .. } => ("coordinates".into(), ""),
            Self::NoPair { key } => (format!("brackets.{key}"), "the key is a pair, \"x, y\""),
            Self::NotLinear { key } | Self::Formula { key, .. } | Self::Name { key, .. } => {
                (key.clone(), "")
            }
            Self::Brackets(_) | Self::Casimirs(_) => ("brackets".into(), ""),
            Self::NoValue { .. } => ("initial".into(), "a value is missing"),
            Self::NoCoordinate { name, .. } | Self::WrongValue { name, .. } => {
                (format!("initial.{name}"), "")
            }
            Self::NoMethod { .. } | Self::NoAttitude => return None,
        };
        Some((key, note))
    }
}
