//! Structure constants in a file of their own.

use crate::errors::Error;
use crate::files::bounded;
use std::path::Path;

/// The largest size of a file, in bytes: more than 15³ constants need.
const MOST_BYTES: u64 = 1 << 20;

/// Returns whether `structure_constants` is a table and not the path of one: a table has lines.
pub(super) fn is_table(text: &str) -> bool {
    text.contains('\n')
}

/// Reads the table in a file.
///
/// # Errors
/// If the file cannot be read, has more than a mebibyte, or is not text.
pub(super) fn read_table(path: &Path) -> Result<String, Error> {
    let text = bounded::read(path, MOST_BYTES)
        .map_err(|source| Error::ReadTable { path: path.into(), source })?;
    // A table of a single line needs its line end to be told from a path.
    Ok(if is_table(&text) { text } else { text + "\n" })
}
