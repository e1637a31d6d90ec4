//! Errors of checkpoints: why a run cannot continue from what an interrupted one has left.

use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// The reason why a run cannot continue from what an interrupted one has left.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CheckpointError {
    /// The checkpoint could not be read.
    #[error("{}", read_problem(.0))]
    Read(io::Error),
    /// The file is not a checkpoint, or not a whole one.
    #[error("it is damaged, or no checkpoint: {0}")]
    Damaged(String),
    /// The file is a configuration.
    #[error(
        "it is a configuration, which stands before the options: heavytop simulate {} --resume --out FILE",
        path.display()
    )]
    NoCheckpoint {
        /// The path of the file.
        path: PathBuf,
    },
    /// The checkpoint is whole, but no run can have made it.
    #[error("no run makes such a checkpoint: it has {0}")]
    Impossible(String),
    /// Another version of the program made the checkpoint; it need not compute the same bits.
    #[error("version {there} made it, and this is {here}")]
    Version {
        /// The version that made the checkpoint.
        there: String,
        /// The version of this program.
        here: &'static str,
    },
    /// A processor with other instructions made the checkpoint, and this one would not compute the same bits.
    #[error(
        "it is of a run on the instructions {there}, and this processor would go on with {here}, to other last digits"
    )]
    Instructions {
        /// The instruction set with which the run was made.
        there: String,
        /// The instruction set with which this processor would continue the run.
        here: String,
    },
    /// The checkpoint belongs to another configuration.
    #[error("it is of another configuration: {}", .0.join("; "))]
    Configuration(Vec<String>),
    /// The checkpoint belongs to an output in another format.
    #[error("it is of an output in {there}, and {} is not", out.display())]
    Format {
        /// The name of the format of its output.
        there: String,
        /// The output asked for.
        out: PathBuf,
    },
    /// The rows could not be read.
    #[error("the rows in {}", path.display())]
    Rows {
        /// The path of the rows.
        path: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// The rows are not those that were written before the checkpoint.
    #[error("the rows in {} are not those that belong to it", path.display())]
    OtherRows {
        /// The path of the rows.
        path: PathBuf,
    },
}

impl CheckpointError {
    /// Returns whether the way to continue is to discard the checkpoint.
    pub(crate) fn is_of_no_use(&self) -> bool {
        match self {
            // The run may have been killed when its output was complete and the checkpoint still there.
            Self::Rows { source, .. } => source.kind() == io::ErrorKind::NotFound,
            Self::Read(_) | Self::NoCheckpoint { .. } | Self::Format { .. } => false,
            _ => true,
        }
    }
}

/// Returns what is wrong with a checkpoint that cannot be read.
fn read_problem(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => {
            "there is none: the run has ended, or was killed before its first checkpoint; to begin anew, leave out --resume".into()
        }
        _ => error.to_string(),
    }
}
