//! Printing to standard output.

use crate::Error;
use serde::Serialize;
use std::fmt::Display;
use std::io::{self, Write};

/// Prints a summary, as text or as JSON.
pub(super) fn print(summary: &(impl Display + Serialize), json: bool) -> Result<(), Error> {
    let written = if json {
        serde_json::to_string_pretty(summary).map_err(Into::into)
    } else {
        Ok(summary.to_string())
    };
    to_stdout(written.and_then(|text| writeln!(io::stdout().lock(), "{text}")))
}

/// Flushes stdout, and returns the outcome of what was written to it.
pub(super) fn to_stdout(written: io::Result<()>) -> Result<(), Error> {
    match written.and_then(|()| io::stdout().flush()) {
        // A reader that closed the pipe has read enough.
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(Error::Write { path: "standard output".into(), source })
        }
        _ => Ok(()),
    }
}
