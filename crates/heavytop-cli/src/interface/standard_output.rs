//! Printing to standard output, and to stderr for machines; texts that fit the terminal.

use super::help::layout::fitted;
use crate::errors::Error;
use console::Term;
use serde::Serialize;
use std::fmt::Display;
use std::io::{self, IsTerminal, Write};

/// The variable by which a user sets the number of columns.
const COLUMNS: &str = "COLUMNS";

/// The least number of columns for which texts are laid out.
const LEAST: usize = 20;

/// Prints a summary, as text or as JSON.
pub(super) fn print(summary: &(impl Display + Serialize), json: bool) -> Result<(), Error> {
    let written = if json {
        serde_json::to_string_pretty(summary).map_err(Into::into)
    } else {
        Ok(summary.to_string())
    };
    to_stdout(written.and_then(|text| writeln!(io::stdout().lock(), "{text}")))
}

/// Prints a line of JSON on stderr. The exit code has to suffice where stderr is closed.
pub(super) fn print_line(object: &impl Serialize) {
    if let Ok(line) = serde_json::to_string(object) {
        let _ = writeln!(io::stderr(), "{line}");
    }
}

/// Prints help on stdout.
pub(super) fn print_help(help: &clap::Error) -> Result<(), Error> {
    to_stdout(print_fitted(help, io::stdout().is_terminal(), io::stdout().lock()))
}

/// Prints a text of the command line on stdout or on stderr, in the columns that there are.
pub(super) fn print_fitted(
    text: &clap::Error,
    is_terminal: bool,
    mut to: impl Write,
) -> io::Result<()> {
    let plain = text.render().to_string();
    match columns(is_terminal).map(|columns| fitted(&plain, columns.max(LEAST))) {
        Some(fitted) if fitted != plain => to.write_all(fitted.as_bytes()),
        // With colours, where there are any.
        _ => text.print(),
    }
}

/// Returns the number of columns that the user has set, or that the terminal has.
fn columns(is_terminal: bool) -> Option<usize> {
    // As in other programs, 0 stands for no number.
    let set = std::env::var(COLUMNS).ok().and_then(|columns| columns.parse().ok());
    let set = set.filter(|columns| *columns > 0);
    set.or_else(|| {
        is_terminal
            .then(|| Term::stdout().size_checked().or(Term::stderr().size_checked()))?
            .map(|(_, columns)| columns.into())
    })
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
