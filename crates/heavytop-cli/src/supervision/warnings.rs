//! Warnings to the user, which do not end a command.

use serde::Serialize;
use std::fmt::Display;
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether messages are for machines.
static IN_JSON: AtomicBool = AtomicBool::new(false);

/// A line of JSON.
#[derive(Serialize)]
struct Warning {
    warning: String,
}

/// Makes each warning of the process a line of JSON: what is on stderr is for machines.
pub(crate) fn in_json() {
    IN_JSON.store(true, Ordering::Relaxed);
}

/// Prints a warning on stderr.
pub(crate) fn warn(warning: impl Display) {
    let text = match IN_JSON.load(Ordering::Relaxed) {
        true => {
            let warning = warning.to_string().trim_start_matches("warning: ").to_owned();
            serde_json::to_string(&Warning { warning }).unwrap_or_default()
        }
        false => format!("heavytop: {warning}"),
    };
    // Where stderr is closed nobody can be warned.
    let _ = writeln!(io::stderr(), "{text}");
}
