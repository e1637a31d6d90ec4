//! The metadata of an output: where it comes from.

use crate::configuration::{Config, Notes};
use crate::errors::Error;
use serde::Serialize;

/// The metadata of an output: the program, its version and the configuration.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Metadata {
    /// The name of the program, `heavytop`.
    pub program: &'static str,
    /// The program's version.
    pub version: &'static str,
    /// The whole configuration, in TOML.
    pub configuration: String,
    /// The Casimirs of a system, the formulas of its columns c1, c2 and so on.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub casimirs: Vec<String>,
    /// The estimated error of a run, to two digits, relative to the state.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_estimate: Option<f64>,
    /// The values that the configuration left out, and the principal axes that were found.
    #[serde(flatten)]
    pub notes: Notes,
}

impl Metadata {
    /// Returns the metadata of a run by this version of the program.
    ///
    /// # Errors
    /// The errors of [`Config::to_toml`].
    pub fn new(config: &Config) -> Result<Self, Error> {
        let (program, version) = ("heavytop", env!("CARGO_PKG_VERSION"));
        let (configuration, notes) = (config.to_toml()?, config.notes());
        let (casimirs, error_estimate) = (Vec::new(), None);
        Ok(Self { program, version, configuration, casimirs, error_estimate, notes })
    }

    /// Returns the metadata with the Casimirs of a system.
    #[must_use]
    pub fn with_casimirs(self, casimirs: Vec<String>) -> Self {
        Self { casimirs, ..self }
    }

    /// Returns the metadata with the estimated error of a run.
    #[must_use]
    pub fn with_error_estimate(self, error_estimate: Option<f64>) -> Self {
        Self { error_estimate, ..self }
    }
}
