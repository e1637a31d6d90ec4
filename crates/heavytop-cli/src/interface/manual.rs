//! The command `man`: manual pages.

use super::arguments::Arguments;
use super::standard_output::to_stdout;
use crate::Error;
use clap::CommandFactory;
use clap_mangen::Man;
use std::io::{self, Write};

/// Prints the manual page of the program, or of one of its commands.
///
/// # Errors
/// If there is no such command, or the page cannot be printed.
pub(super) fn man(command: Option<&str>) -> Result<(), Error> {
    let mut program = Arguments::command();
    // The commands get their full names, `heavytop simulate`, and the options of the whole program.
    program.build();
    let page = match command {
        None => program,
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| {
            let names = program.get_subcommands().map(|known| known.get_name().to_string());
            Error::NoCommand { name: name.into(), names: names.collect() }
        })?,
    };
    let mut text = Vec::new();
    let rendered = Man::new(page).render(&mut text);
    to_stdout(rendered.and_then(|()| io::stdout().lock().write_all(&text)))
}
