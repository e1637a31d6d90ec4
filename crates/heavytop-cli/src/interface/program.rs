//! The program: from the arguments of its process to its exit code.

use super::arguments::{Arguments, Command, Parts, Top};
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
use crate::commands::section::{self, section};
use crate::commands::simulate::{
    self, Checkpoint, RunSummary, SimulateOptions, SystemSummary, simulate, simulate_system,
};
use crate::commands::sweep::{self, sweep_if};
use crate::runs::SystemExperiment;
use crate::runs::method_warning::{method_warning, system_warning};
use crate::runs::step_angle::long_step;
use crate::supervision::{Forecast, TileOptions, Watch};
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
    let closing = Closing { begun: Instant::now(), json, quiet };
    match command {
        Command::Reproduce { out, end, step } => {
            reproduce(&out, step, end, &watch(quiet)).and_then(|done| closing.print(&done))
        }
        Command::Simulate { top, out, dry_run: true, .. } => {
            top.run(|config| simulate::dry_run(&config, &out)).and_then(|done| print(&done, json))
        }
        Command::Simulate { top, out, resume, restart, checkpoint_interval, yes, .. } => {
            let (resume, interval) = (resume.as_deref(), checkpoint_interval);
            let begin = Begin { resume, restart, interval, yes };
            match run_simulate(&top, &out, &begin, quiet)? {
                Simulated::Top(summary) => closing.end(&summary),
                Simulated::System(summary) => closing.end(&summary),
            }
        }
        Command::Compare { top, out, end } => top
            .run(|config| compare(&config, &out, end, &watch(quiet)))
            .and_then(|done| closing.print(&done)),
        Command::Section { top, out, parts: Parts { dry_run: true, .. } } => top
            .run(|config| section::dry_run(&config, &out, top.threads))
            .and_then(|done| print(&done, json)),
        Command::Section { top, out, parts } => top
            .run(|config| {
                if !parts.resume {
                    confirm(&section::forecast(&config, &out)?, parts.yes)?;
                }
                section(&config, &out, &in_tiles(&top, parts, quiet))
            })
            .and_then(|done| closing.print(&done)),
        Command::Sweep { top, out, parts: Parts { dry_run: true, .. } } => top
            .run(|config| sweep::dry_run(&config, &out, top.threads))
            .and_then(|done| done.map_or(Ok(()), |done| print(&done, json))),
        Command::Sweep { top, out, parts } => top
            .run(|config| {
                let agree = |forecast: &Forecast| confirm(forecast, parts.yes);
                sweep_if(&config, &out, &in_tiles(&top, parts, quiet), agree)
            })
            .and_then(|done| done.map_or(Ok(()), |done| closing.print(&done))),
        Command::Animate { top, out } => top
            .run(|config| animate(config, &out, &watch(quiet)))
            .and_then(|summary| closing.end(&summary)),
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

/// The end of a command: its summary, and a line on stderr that says how long it took.
struct Closing {
    begun: Instant,
    json: bool,
    quiet: bool,
}

impl Closing {
    /// Ends a command whose numbers are in its file: the summary is part of the line.
    fn end(&self, summary: &(impl Display + Serialize)) -> Result<(), Error> {
        if self.json {
            return print(summary, true);
        }
        self.say(&format!(": {summary}"));
        Ok(())
    }

    /// Ends a command whose summary goes to stdout.
    fn print(&self, summary: &(impl Display + Serialize)) -> Result<(), Error> {
        print(summary, self.json)?;
        self.say("");
        Ok(())
    }

    fn say(&self, what: &str) {
        if !(self.json || self.quiet) {
            let seconds = self.begun.elapsed().as_secs_f64();
            // The command has succeeded where stderr is closed, too.
            let _ = writeln!(io::stderr(), "heavytop: done{what}; {seconds:.2} s");
        }
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

/// The motion that `simulate` has followed.
enum Simulated {
    Top(RunSummary),
    System(SystemSummary),
}

fn run_simulate(top: &Top, out: &Path, begin: &Begin<'_>, quiet: bool) -> Result<Simulated, Error> {
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
            confirm(&simulate::forecast(&config, out)?, yes)?;
        }
        let stop = Some(interrupted());
        let options = SimulateOptions { resume: resume.as_ref(), restart, interval, stop, quiet };
        if let Some(system) = config.system_experiment()? {
            let SystemExperiment { system: formula, start, method, .. } = &system;
            if let Some(warning) = system_warning(method, formula, start)? {
                // Where stderr is closed nobody can be warned.
                let _ = writeln!(io::stderr(), "heavytop: {warning}");
            }
            return simulate_system(&config, &system, out, &options).map(Simulated::System);
        }
        let experiment = config.experiment()?;
        for warning in
            [method_warning(&experiment.method), long_step(&experiment)].into_iter().flatten()
        {
            // Where stderr is closed nobody can be warned.
            let _ = writeln!(io::stderr(), "heavytop: {warning}");
        }
        simulate(&config, out, &options).map(Simulated::Top)
    })
}

/// Returns the options of a command that keeps its finished parts.
fn in_tiles(top: &Top, parts: Parts, quiet: bool) -> TileOptions<'static> {
    let Parts { resume, restart, .. } = parts;
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
