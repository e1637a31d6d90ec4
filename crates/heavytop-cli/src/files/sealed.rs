//! Files that an interrupted run has left for the one that goes on: whole, and of this version.

use super::bounded;
use crate::errors::CheckpointError;
use std::io;
use std::path::Path;
use toml::Table;

/// More bytes than this have no checkpoint and no identity.
const MOST_BYTES: u64 = 1 << 24;

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
