//! The program: from the arguments of its process to its exit code.

use super::arguments::{Arguments, Command, Top};
use super::confirmation::confirm;
use super::first_configuration::init;
use super::manual::man;
use super::signals::interrupted;
use super::standard_output::{print, to_stdout};
use crate::Error;
use crate::commands::animate::animate;
use crate::commands::bench::{BenchOptions, bench};
use crate::commands::compare::compare;
use crate::commands::reproduce::reproduce;
use crate::commands::section::section;
use crate::commands::simulate::{Checkpoint, Forecast, RunSummary, SimulateOptions, simulate};
use crate::commands::sweep::sweep;
use crate::runs::step_angle::long_step;
use crate::supervision::{TileOptions, Watch};
use clap::{CommandFactory, Parser};
use clap_complete::Shell;
use serde::Serialize;
use std::fmt::Display;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Runs the program with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    let done = match Arguments::try_parse() {
        Ok(arguments) => run(arguments),
        Err(error) if error.use_stderr() => {
            // The exit code has to suffice where stderr is closed.
            let _ = error.print();
            return ExitCode::from(2);
        }
        // The user asked for help, or for the version.
        Err(help) => to_stdout(help.print()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => report(&error),
    }
}

fn run(Arguments { quiet, json, command }: Arguments) -> Result<(), Error> {
    let closing = Closing { begun: Instant::now() };
    match command {
        Command::Reproduce { out, end, step } => {
            reproduce(&out, step, end, &watch(quiet)).and_then(|done| print(&done, json))
        }
        Command::Simulate { top, out, dry_run: true, .. } => {
            top.run(|config| Forecast::tried(&config, &out)).and_then(|done| print(&done, json))
        }
        Command::Simulate { top, out, resume, restart, checkpoint_interval, yes, .. } => {
            let (resume, interval) = (resume.as_deref(), checkpoint_interval);
            let begin = Begin { resume, restart, interval, yes };
            let done = run_simulate(&top, &out, &begin, quiet);
            done.and_then(|summary| closing.end(&summary, json, quiet))
        }
        Command::Compare { top, out, end } => top
            .run(|config| compare(&config, &out, end, &watch(quiet)))
            .and_then(|done| print(&done, json)),
        Command::Section { top, out, resume, restart } => top
            .run(|config| section(&config, &out, &in_tiles(&top, resume, restart, quiet)))
            .and_then(|done| print(&done, json)),
        Command::Sweep { top, out, resume, restart } => top
            .run(|config| sweep(&config, &out, &in_tiles(&top, resume, restart, quiet)))
            .and_then(|done| done.map_or(Ok(()), |done| print(&done, json))),
        Command::Animate { top, out } => top
            .run(|config| animate(config, &out, &watch(quiet)))
            .and_then(|summary| closing.end(&summary, json, quiet)),
        Command::Bench { top, problem, only, tops } => top
            .run(|config| {
                let threads = top.threads.unwrap_or(1);
                let options = BenchOptions { only, tops, threads };
                bench(&config, problem.as_deref(), options, quiet)
            })
            .and_then(|done| print(&done, json)),
        Command::Init { file, preset } => init(preset, file.as_deref()),
        Command::Man { command } => man(command.as_deref()),
        Command::Completions { shell } => completions(shell),
    }
}

/// Prints the closing line of a command whose numbers are in its file.
struct Closing {
    begun: Instant,
}

impl Closing {
    /// Prints the summary as JSON, or says on stderr in one line what was done and how long it took.
    fn end(
        &self,
        summary: &(impl Display + Serialize),
        json: bool,
        quiet: bool,
    ) -> Result<(), Error> {
        if json {
            return print(summary, json);
        }
        if !quiet {
            let seconds = self.begun.elapsed().as_secs_f64();
            // The run has succeeded where stderr is closed, too.
            let _ = writeln!(io::stderr(), "heavytop: done: {summary}; {seconds:.2} s");
        }
        Ok(())
    }
}

fn completions(shell: Shell) -> Result<(), Error> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "heavytop", &mut script);
    to_stdout(io::stdout().lock().write_all(&script))
}

/// The start of `simulate`, and how often it renews its checkpoint.
struct Begin<'a> {
    resume: Option<&'a Path>,
    restart: bool,
    /// The time between checkpoints, s.
    interval: f64,
    /// Whether not to ask before an output that is absurdly large.
    yes: bool,
}

fn run_simulate(
    top: &Top,
    out: &Path,
    begin: &Begin<'_>,
    quiet: bool,
) -> Result<RunSummary, Error> {
    let Begin { resume, restart, interval, yes } = *begin;
    let resume = resume.map(Checkpoint::read).transpose()?;
    let range = "not negative, and at most 1e9";
    let interval = Duration::try_from_secs_f64(interval)
        .ok()
        .filter(|interval| interval.as_secs_f64() <= 1e9)
        .ok_or(Error::OutOfRange { name: "checkpoint-interval", range, value: interval })?;
    top.run(|config| {
        let config = match &resume {
            // The checkpoint has its own configuration.
            Some(checkpoint) if top.is_default() => checkpoint.configuration().clone(),
            _ => config,
        };
        if resume.is_none() {
            confirm(&Forecast::of(&config, out)?, yes)?;
        }
        let experiment = config.experiment()?;
        for warning in [experiment.method.warning(), long_step(&experiment)].into_iter().flatten() {
            // Where stderr is closed nobody can be warned.
            let _ = writeln!(io::stderr(), "heavytop: {warning}");
        }
        let stop = Some(interrupted());
        let options = SimulateOptions { resume: resume.as_ref(), restart, interval, stop, quiet };
        simulate(&config, out, &options)
    })
}

/// Returns the options of a command that keeps its finished parts.
fn in_tiles(top: &Top, resume: bool, restart: bool, quiet: bool) -> TileOptions<'static> {
    TileOptions { resume, restart, stop: Some(interrupted()), threads: top.threads, quiet }
}

/// Returns the options of a command that keeps nothing when it is interrupted.
fn watch(quiet: bool) -> Watch<'static> {
    Watch { stop: Some(interrupted()), quiet }
}

fn report(error: &Error) -> ExitCode {
    // The exit code has to suffice where stderr is closed.
    let _ = writeln!(io::stderr(), "heavytop: {}", error.message());
    error.exit_code().into()
}
