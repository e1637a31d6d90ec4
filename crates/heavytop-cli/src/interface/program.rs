//! The program: from the arguments of its process to its exit code.

use super::arguments::{Arguments, Command, Top};
use super::signals::interrupted;
use super::standard_output::{print, to_stdout};
use crate::Error;
use crate::commands::animate::animate;
use crate::commands::bench::{BenchOptions, bench};
use crate::commands::compare::compare;
use crate::commands::reproduce::reproduce;
use crate::commands::section::section;
use crate::commands::simulate::{Checkpoint, RunSummary, SimulateOptions, simulate};
use crate::commands::sweep::sweep;
use crate::supervision::{TileOptions, Watch};
use clap::{CommandFactory, Parser};
use clap_complete::Shell;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

/// Runs the program with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    let done = match Arguments::try_parse() {
        Ok(arguments) => run(arguments),
        Err(error) if error.use_stderr() => {
            // Where stderr is closed the exit code has to do.
            let _ = error.print();
            return ExitCode::from(2);
        }
        // What was asked for is help, or the version.
        Err(help) => to_stdout(help.print()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => report(&error),
    }
}

fn run(Arguments { quiet, json, command }: Arguments) -> Result<(), Error> {
    match command {
        Command::Reproduce { out, end, step } => {
            reproduce(&out, step, end, &watch(quiet)).and_then(|done| print(&done, json))
        }
        Command::Simulate { top, out, resume, restart, checkpoint_interval } => {
            let begin = Begin { resume: resume.as_deref(), restart, interval: checkpoint_interval };
            let done = run_simulate(&top, &out, &begin, quiet);
            // Its numbers are in the file; there is nothing else to say.
            done.and_then(|summary| if json { print(&summary, json) } else { Ok(()) })
        }
        Command::Compare { top, out } => top
            .config()
            .and_then(|config| compare(&config, &out, &watch(quiet)))
            .and_then(|done| print(&done, json)),
        Command::Section { top, out, resume, restart } => top
            .config()
            .and_then(|config| section(&config, &out, &in_tiles(resume, restart, quiet)))
            .and_then(|done| print(&done, json)),
        Command::Sweep { top, out, resume, restart } => top
            .config()
            .and_then(|config| sweep(&config, &out, &in_tiles(resume, restart, quiet)))
            .and_then(|done| done.map_or(Ok(()), |done| print(&done, json))),
        Command::Animate { top, out } => top
            .config()
            .and_then(|config| animate(config, &out, &watch(quiet)))
            // The page says the same.
            .and_then(|summary| if json { print(&summary, json) } else { Ok(()) }),
        Command::Bench { top, problem, only, tops, threads } => top
            .config()
            .and_then(|config| {
                let options = BenchOptions { only, tops, threads };
                bench(&config, problem.as_deref(), options, quiet)
            })
            .and_then(|done| print(&done, json)),
        Command::Completions { shell } => completions(shell),
    }
}

fn completions(shell: Shell) -> Result<(), Error> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "heavytop", &mut script);
    to_stdout(io::stdout().lock().write_all(&script))
}

/// From where `simulate` begins, and how often it renews its checkpoint.
struct Begin<'a> {
    resume: Option<&'a Path>,
    restart: bool,
    /// s
    interval: f64,
}

fn run_simulate(
    top: &Top,
    out: &Path,
    begin: &Begin<'_>,
    quiet: bool,
) -> Result<RunSummary, Error> {
    let Begin { resume, restart, interval } = *begin;
    let resume = resume.map(Checkpoint::read).transpose()?;
    let config = match &resume {
        // The checkpoint has its own.
        Some(checkpoint) if top.is_default() => checkpoint.configuration().clone(),
        _ => top.config()?,
    };
    let range = "not negative, and at most 1e9";
    let interval = Duration::try_from_secs_f64(interval)
        .ok()
        .filter(|interval| interval.as_secs_f64() <= 1e9)
        .ok_or(Error::OutOfRange { name: "checkpoint-interval", range, value: interval })?;
    let method = config.experiment()?.method;
    if let Some(warning) = method.warning() {
        // Where stderr is closed nobody can be warned.
        let _ = writeln!(io::stderr(), "heavytop: {warning}");
    }
    let stop = Some(interrupted());
    let options = SimulateOptions { resume: resume.as_ref(), restart, interval, stop, quiet };
    simulate(&config, out, &options)
}

/// How a command is accompanied whose finished parts are kept.
fn in_tiles(resume: bool, restart: bool, quiet: bool) -> TileOptions<'static> {
    TileOptions { resume, restart, stop: Some(interrupted()), quiet }
}

/// What accompanies a command that keeps nothing when it is interrupted.
fn watch(quiet: bool) -> Watch<'static> {
    Watch { stop: Some(interrupted()), quiet }
}

fn report(error: &Error) -> ExitCode {
    // Where stderr is closed the exit code has to do.
    let _ = writeln!(io::stderr(), "heavytop: {}", error.message());
    error.exit_code().into()
}
