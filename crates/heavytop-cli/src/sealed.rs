//! Files that an interrupted run has left for the one that goes on: whole, and of this version.

use crate::bounded;
use crate::formats::Format;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;
use toml::Table;

/// More bytes than this have no checkpoint and no identity.
const MOST_BYTES: u64 = 1 << 24;

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
        /// The format of its output.
        there: Format,
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

/// The text of a sealed file.
///
/// # Errors
/// If it cannot be read, or is no text, or too long.
pub(crate) fn read(path: &Path) -> Result<String, CheckpointError> {
    bounded::read(path, MOST_BYTES).map_err(|error| match error.kind() {
        io::ErrorKind::InvalidData => CheckpointError::Damaged("it is no text".into()),
        io::ErrorKind::FileTooLarge => CheckpointError::Damaged(error.to_string()),
        _ => CheckpointError::Read(error),
    })
}

/// The contents after a line of the title and their checksum.
pub(crate) fn seal(title: &str, contents: &str) -> String {
    format!("{title}{:08x}\n{contents}", crc32fast::hash(contents.as_bytes()))
}

/// The contents of what was sealed under this title.
///
/// # Errors
/// If it was not, or is not whole.
pub(crate) fn open<'a>(title: &str, text: &'a str) -> Result<&'a str, CheckpointError> {
    let damaged = |what: &str| CheckpointError::Damaged(what.into());
    let (line, contents) = text.split_once('\n').ok_or_else(|| damaged("it ends early"))?;
    let checksum = line.strip_prefix(title).ok_or_else(|| damaged("it has no title"))?;
    if checksum != format!("{:08x}", crc32fast::hash(contents.as_bytes())) {
        return Err(damaged("its checksum is not that of its contents"));
    }
    Ok(contents)
}

/// The TOML of a checkpoint that this version has made.
///
/// # Errors
/// If it is not TOML, or of another version, whose keys may be others.
pub(crate) fn of_this_version(contents: &str) -> Result<Table, CheckpointError> {
    let table: Table = contents.parse().map_err(damaged)?;
    let (there, here) = (table.get("version"), env!("CARGO_PKG_VERSION"));
    match there.and_then(|there| there.as_str()).filter(|&there| there != here) {
        Some(there) => Err(CheckpointError::Version { there: there.into(), here }),
        None => Ok(table),
    }
}

/// That it is no TOML, or has other keys.
pub(crate) fn damaged(error: toml::de::Error) -> CheckpointError {
    CheckpointError::Damaged(error.message().into())
}
