//! What a run needs to go on after it was interrupted.

use super::growing::Mark;
use crate::Error;
use crate::config::Config;
use crate::formats::Format;
use crate::output::Output;
use crate::run::Saved;
use serde::{Deserialize, Serialize};
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The first word of the file, before the checksum of what follows its first line.
const TITLE: &str = "heavytop-checkpoint ";

/// Why a run cannot go on from a checkpoint.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// It could not be read.
    #[error("{0}")]
    Read(#[source] io::Error),
    /// It is not a checkpoint, or not a whole one.
    #[error("it is damaged, or no checkpoint: {0}")]
    Damaged(String),
    /// Another version made it, which need not compute the same bits.
    #[error("version {there} made it, and this is {here}")]
    Version {
        /// The version that made it.
        there: String,
        /// This version.
        here: &'static str,
    },
    /// It is of another configuration.
    #[error("it is of another configuration: {}", .0.join("; "))]
    Configuration(Vec<String>),
    /// It is of an output of another format.
    #[error("it is of an output in {there}, and {} is not", out.display())]
    Format {
        /// The format of its output.
        there: Format,
        /// The output asked for.
        out: PathBuf,
    },
    /// The rows could not be read.
    #[error("the rows in {}: {source}", path.display())]
    Rows {
        /// Their file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The rows are not those that were written before the checkpoint.
    #[error("the rows in {} are not those that belong to it", path.display())]
    OtherRows {
        /// Their file.
        path: PathBuf,
    },
}

/// A step of a run, from which it can go on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Checkpoint {
    version: String,
    /// That of the output.
    format: Format,
    step: u64,
    /// The coordinates of the integrator's state: written so that they read back as the same bits.
    state: Vec<f64>,
    /// The largest deviations of the invariants so far.
    pub(super) deviations: Vec<f64>,
    /// The rows so far.
    pub(super) rows: Mark,
    configuration: Config,
}

impl Checkpoint {
    pub(super) fn new(
        config: &Config,
        format: Format,
        saved: Saved,
        deviations: &[f64],
        rows: Mark,
    ) -> Self {
        let Saved { step, state } = saved;
        let (version, deviations) = (env!("CARGO_PKG_VERSION").into(), deviations.into());
        Self { version, format, step, state, deviations, rows, configuration: config.clone() }
    }

    /// Reads a checkpoint.
    ///
    /// # Errors
    /// If it cannot be read, is damaged, or of another version of the program.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let text = std::fs::read_to_string(path).map_err(CheckpointError::Read);
        text.and_then(|text| Self::parse(&text))
            .map_err(|source| Error::Checkpoint { path: path.into(), source })
    }

    fn parse(text: &str) -> Result<Self, CheckpointError> {
        let damaged = |what: &str| CheckpointError::Damaged(what.into());
        let (title, contents) = text.split_once('\n').ok_or_else(|| damaged("it ends early"))?;
        let checksum = title.strip_prefix(TITLE).ok_or_else(|| damaged("it has no title"))?;
        if checksum != self::checksum(contents) {
            return Err(damaged("its checksum is not that of its contents"));
        }
        // Of the version first: that of another one may have other keys.
        let table: toml::Table =
            contents.parse().map_err(|e: toml::de::Error| damaged(e.message()))?;
        let (there, here) = (table.get("version"), env!("CARGO_PKG_VERSION"));
        if let Some(there) = there.and_then(|there| there.as_str()).filter(|&there| there != here) {
            return Err(CheckpointError::Version { there: there.into(), here });
        }
        table.try_into().map_err(|e: toml::de::Error| damaged(e.message()))
    }

    /// Writes it, whole or not at all.
    pub(super) fn write(&self, path: &Path) -> Result<(), Error> {
        let contents = toml::to_string(self).map_err(Error::Unwritable)?;
        let title = format!("{TITLE}{}\n", checksum(&contents));
        Output::whole(path, (title + &contents).as_bytes())
    }

    /// The configuration of the run.
    #[must_use]
    pub fn configuration(&self) -> &Config {
        &self.configuration
    }

    /// The step, and the integrator's state after it.
    #[must_use]
    pub fn saved(&self) -> Saved {
        Saved { step: self.step, state: self.state.clone() }
    }

    /// Checks that it is of this configuration and of an output in this format.
    pub(super) fn require(
        &self,
        config: &Config,
        format: Format,
        out: &Path,
    ) -> Result<(), CheckpointError> {
        let differences = self.configuration.differences(config);
        let differences = differences.map_err(|e| CheckpointError::Damaged(e.to_string()))?;
        if !differences.is_empty() {
            return Err(CheckpointError::Configuration(differences));
        }
        if self.format != format {
            return Err(CheckpointError::Format { there: self.format, out: out.into() });
        }
        Ok(())
    }
}

fn checksum(contents: &str) -> String {
    format!("{:08x}", crc32fast::hash(contents.as_bytes()))
}
