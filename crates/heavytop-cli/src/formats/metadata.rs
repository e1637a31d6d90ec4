//! What an output says of its origin.

use crate::Error;
use crate::configuration::Config;
use serde::Serialize;

/// What an output says of its origin.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Metadata {
    /// heavytop
    pub program: &'static str,
    /// The program's version.
    pub version: &'static str,
    /// The whole configuration, in TOML.
    pub configuration: String,
}

impl Metadata {
    /// That of a run of this version of the program.
    ///
    /// # Errors
    /// As [`Config::to_toml`].
    pub fn new(config: &Config) -> Result<Self, Error> {
        let (program, version) = ("heavytop", env!("CARGO_PKG_VERSION"));
        Ok(Self { program, version, configuration: config.to_toml()? })
    }
}
