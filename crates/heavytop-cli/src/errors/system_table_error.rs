//! Errors of `[system]`: why a configuration describes no Lie–Poisson system.

use lie_poisson_formula_systems::{FormulaSystemError, StructureTableError};
use lie_poisson_formulas::NameError;
use thiserror::Error;

/// The reason why a configuration describes no Lie–Poisson system.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SystemTableError {
    /// A command for tops got a system.
    #[error("only simulate, section and sweep run a system; the other commands are for tops")]
    CommandOfTops,
    /// A table of tops stands beside the system.
    #[error("a system has no [{0}], which is of tops: its keys are in [system]")]
    Top(&'static str),
    /// A key is missing.
    #[error("{0} is missing")]
    Missing(&'static str),
    /// There are several algebras: by name, of brackets, of structure constants.
    #[error(
        "write one of algebra, coordinates with brackets, and structure_constants with or without coordinates"
    )]
    TwoAlgebras,
    /// The structure constants are no table of a Lie algebra.
    #[error("structure_constants")]
    StructureConstants(#[source] StructureTableError),
    /// A name cannot be that of a parameter.
    #[error("parameters.{name}")]
    Parameter {
        /// The name of the parameter.
        name: String,
        /// The error of the name.
        source: NameError,
    },
    /// There is no such system, no such method for it, or no such initial state.
    #[error(transparent)]
    Formula(#[from] FormulaSystemError),
    /// The attitude of a system that is no body is asked for.
    #[error("a system has no attitude")]
    NoAttitude,
}

impl SystemTableError {
    /// Returns the key at fault, below `[system]`, with what to write there.
    #[must_use]
    pub fn key(&self) -> Option<(String, &'static str)> {
        Some(match self {
            Self::CommandOfTops => (String::new(), "use simulate, section or sweep"),
            Self::Missing(_) => (String::new(), "add the key"),
            Self::TwoAlgebras => (String::new(), "leave out all but one"),
            Self::StructureConstants(_) => ("structure_constants".into(), ""),
            Self::Parameter { name, .. } => (format!("parameters.{name}"), ""),
            Self::Formula(error) => return key_of(error),
            Self::Top(_) | Self::NoAttitude => return None,
        })
    }
}

/// Returns the key at fault for an error of the library.
fn key_of(error: &FormulaSystemError) -> Option<(String, &'static str)> {
    use FormulaSystemError as E;
    Some(match error {
        E::Structure(_) => ("structure_constants".into(), ""),
        E::NoAlgebra { .. } => ("algebra".into(), ""),
        E::Dimension { .. } | E::Coordinates(_) => ("coordinates".into(), ""),
        E::Parameters(_) => ("parameters".into(), ""),
        E::NoPair { key } => (format!("brackets.{key}"), "the key is a pair, \"x, y\""),
        E::Bracket { key, .. } | E::NotLinear { key } => (format!("brackets.{key}"), ""),
        E::Jacobi { .. } | E::Brackets(_) | E::Casimirs(_) => ("brackets".into(), ""),
        E::Hamiltonian(_) => ("hamiltonian".into(), ""),
        E::NoValue { .. } => ("initial".into(), "a value is missing"),
        E::NoCoordinate { name, .. } | E::WrongValue { name, .. } => {
            (format!("initial.{name}"), "")
        }
        _ => return None,
    })
}
