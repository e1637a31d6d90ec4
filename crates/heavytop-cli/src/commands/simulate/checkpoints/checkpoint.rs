//! The checkpoint of a run, from which an interrupted run continues.

use super::growing_file::Mark;
use crate::configuration::{Config, LeftOut, inner, read_saved};
use crate::errors::{CheckpointError, Error};
use crate::files::sealed::{damaged, of_this_version, open, read, seal};
use crate::files::{Kind, Output};
use crate::formats::{Format, RunTable};
use crate::runs::Saved;
use crate::vocabulary::brief::number;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// The first word of the file, before the checksum of what follows its first line.
const TITLE: &str = "heavytop-checkpoint ";

/// How a checkpoint is recognised.
pub(in crate::commands::simulate) const KIND: Kind<'_> =
    Kind::of_first_bytes("checkpoint of simulate", TITLE.as_bytes());

/// The state of a run after a step, from which the run can continue.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Checkpoint {
    /// The file from which it was read.
    #[serde(skip)]
    pub(in crate::commands::simulate) path: PathBuf,
    version: String,
    /// The instruction set on which the bits of the steps depend.
    instructions: String,
    /// The format of the output.
    format: Format,
    step: u64,
    /// The coordinates of the integrator's state, written so that they read back as the same bits.
    #[serde(with = "super::state_text")]
    state: Vec<f64>,
    /// The largest deviations of the invariants so far.
    pub(in crate::commands::simulate) deviations: Vec<f64>,
    /// The extent of the rows so far.
    pub(in crate::commands::simulate) rows: Mark,
    /// What the configuration left out where it was read.
    #[serde(default, skip_serializing_if = "LeftOut::is_empty")]
    left_out: LeftOut,
    #[serde(deserialize_with = "inner")]
    configuration: Config,
}

impl Checkpoint {
    pub(in crate::commands::simulate) fn new(
        config: &Config,
        format: Format,
        saved: Saved,
        deviations: &[f64],
        rows: Mark,
    ) -> Self {
        let Saved { step, state } = saved;
        let (version, configuration) = (env!("CARGO_PKG_VERSION").into(), config.clone());
        let (path, deviations) = (PathBuf::new(), deviations.into());
        let instructions = config.instructions().to_string();
        let left_out = config.left_out.clone();
        Self {
            path,
            version,
            instructions,
            format,
            step,
            state,
            deviations,
            rows,
            left_out,
            configuration,
        }
    }

    /// Reads a checkpoint from its file.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged or a configuration, or was written by another version of the program.
    pub fn read(path: &Path) -> Result<Self, Error> {
        read(path)
            .and_then(|text| match is_configuration(&text) {
                true => Err(CheckpointError::NoCheckpoint { path: path.into() }),
                false => Self::parse(&text),
            })
            .map(|checkpoint| Self { path: path.into(), ..checkpoint })
            .map_err(|source| Error::Checkpoint { path: path.into(), source })
    }

    fn parse(text: &str) -> Result<Self, CheckpointError> {
        let table = of_this_version(open(TITLE, text)?)?;
        let mut read: Self = read_saved(table).map_err(damaged)?;
        read.configuration.left_out = read.left_out.clone();
        Ok(read)
    }

    /// Writes the checkpoint, whole or not at all.
    pub(in crate::commands::simulate) fn write(&self, path: &Path) -> Result<(), Error> {
        let contents = toml::to_string(self).map_err(Error::Unwritable)?;
        Output::whole(path, seal(TITLE, &contents).as_bytes())
    }

    /// Returns the configuration of the run.
    #[must_use]
    pub fn configuration(&self) -> &Config {
        &self.configuration
    }

    /// Returns the number of steps, and the integrator's state after them.
    #[must_use]
    pub fn saved(&self) -> Saved {
        Saved { step: self.step, state: self.state.clone() }
    }

    /// Checks that the checkpoint is for this configuration and this output format.
    pub(in crate::commands::simulate) fn require(
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
        config.require_instructions(&self.instructions)?;
        if self.format != format {
            return Err(CheckpointError::Format {
                there: self.format.to_string(),
                out: out.into(),
            });
        }
        Ok(())
    }

    /// Checks that a run of so many steps, which can be resumed at some multiples, and whose states have so many coordinates, can have made the checkpoint. The run is
    /// the one of the checkpoint's configuration.
    ///
    /// # Errors
    /// [`CheckpointError::Impossible`], with what is wrong.
    pub(in crate::commands::simulate) fn require_possible(
        &self,
        (steps, resumable_after): (u64, u64),
        dimension: usize,
        table: &RunTable,
    ) -> Result<(), CheckpointError> {
        let step = self.step;
        let invariants = table.invariants().len();
        let impossible = if step >= steps {
            format!("step {step} of a run of {steps}")
        } else if !step.is_multiple_of(resumable_after) {
            format!("step {step}, which is no multiple of {resumable_after}")
        } else if self.state.len() != dimension {
            format!("a state of {} numbers, not {dimension}", self.state.len())
        } else if let Some(x) = self.state.iter().find(|x| !x.is_finite()) {
            format!("a state with {x}")
        } else if self.deviations.len() != invariants {
            format!("{} deviations of {invariants} invariants", self.deviations.len())
        } else if let Some(x) = self.deviations.iter().find(|x| **x < 0.0) {
            format!("a deviation of {}", number(*x))
        } else {
            return Ok(());
        };
        Err(CheckpointError::Impossible(impossible))
    }
}

/// Returns whether a text is a configuration; an empty one is none.
fn is_configuration(text: &str) -> bool {
    !text.trim().is_empty()
        && toml::from_str(text).is_ok_and(|table| Config::of_table(table).is_ok())
}
