//! Why a run cannot go on from what an interrupted one has left.

use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a run cannot go on from what an interrupted one has left.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// It could not be read.
    #[error(transparent)]
    Read(io::Error),
    /// It is not a checkpoint, or not a whole one.
    #[error("it is damaged, or no checkpoint: {0}")]
    Damaged(String),
    /// It is whole, and no run can have made it.
    #[error("no run makes such a checkpoint: it has {0}")]
    Impossible(String),
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
        /// The format of its output, by name.
        there: String,
        /// The output asked for.
        out: PathBuf,
    },
    /// The rows could not be read.
    #[error("the rows in {}", path.display())]
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

impl CheckpointError {
    /// Whether to discard it is a way to go on.
    pub(crate) fn is_of_no_use(&self) -> bool {
        !matches!(self, Self::Read(_) | Self::Format { .. } | Self::Rows { .. })
    }
}
