//! Sealed files, which an interrupted run leaves for the one that resumes it: complete, and from this version.

use super::bounded;
use crate::errors::CheckpointError;
use std::io;
use std::path::Path;
use toml::Table;

/// The largest size of a checkpoint or an identity, in bytes. What is no regular file may have no end.
const MOST_BYTES: u64 = 1 << 30;
const MOST_OF_OTHERS: u64 = 1 << 24;

/// Reads the text of a sealed file.
///
/// # Errors
/// If the file cannot be read, is not text, or is too long.
pub(crate) fn read(path: &Path) -> Result<String, CheckpointError> {
    let is_regular = path.metadata().is_ok_and(|found| found.is_file());
    let most = if is_regular { MOST_BYTES } else { MOST_OF_OTHERS };
    bounded::read(path, most).map_err(|error| match error.kind() {
        io::ErrorKind::InvalidData => CheckpointError::Damaged("it is no text".into()),
        io::ErrorKind::FileTooLarge => CheckpointError::Damaged(error.to_string()),
        _ => CheckpointError::Read(error),
    })
}

/// Puts a line with the title and the checksum before the contents.
pub(crate) fn seal(title: &str, contents: &str) -> String {
    format!("{title}{:08x}\n{contents}", crc32fast::hash(contents.as_bytes()))
}

/// Returns the contents of a text that was sealed under this title.
///
/// # Errors
/// If the text was not sealed so, or is incomplete.
pub(crate) fn open<'a>(title: &str, text: &'a str) -> Result<&'a str, CheckpointError> {
    let damaged = |what: &str| CheckpointError::Damaged(what.into());
    let (line, contents) = text.split_once('\n').ok_or_else(|| damaged("it ends early"))?;
    let checksum = line.strip_prefix(title).ok_or_else(|| damaged("it has no title"))?;
    if checksum != format!("{:08x}", crc32fast::hash(contents.as_bytes())) {
        return Err(damaged("its checksum is not that of its contents"));
    }
    Ok(contents)
}

/// Parses the TOML of a checkpoint that this version has made.
///
/// # Errors
/// If the contents are not TOML, or another version has made them, whose keys may be different.
pub(crate) fn of_this_version(contents: &str) -> Result<Table, CheckpointError> {
    let table: Table = contents.parse().map_err(damaged)?;
    let (there, here) = (table.get("version"), env!("CARGO_PKG_VERSION"));
    match there.and_then(|there| there.as_str()).filter(|&there| there != here) {
        Some(there) => Err(CheckpointError::Version { there: there.into(), here }),
        None => Ok(table),
    }
}

/// Returns the error that the contents are not TOML, or have other keys.
pub(crate) fn damaged(error: toml::de::Error) -> CheckpointError {
    CheckpointError::Damaged(error.message().into())
}
