//! The program: from the arguments of its process to its exit code.

use super::arguments::{Arguments, Command, Parts, Replacing, Top};
use super::beginnings::first_configuration::init;
use super::beginnings::first_system::init_system;
use super::confirmation::confirm;
use super::manual::man;
use super::signals::interrupted;
use super::standard_output::{print, print_fitted, print_help, print_line, to_stdout};
use super::suggested_command::suggest_command;
use crate::commands::animate::animate;
use crate::commands::bench::{BenchOptions, bench};
use crate::commands::compare::compare;
use crate::commands::ensemble::ensemble;
use crate::commands::events::events;
use crate::commands::export::export;
use crate::commands::plot::{PlotOptions, plot, plot_as_text};
use crate::commands::report::report;
use crate::commands::reproduce::reproduce;
use crate::commands::section::{self, section};
use crate::commands::simulate::{
    self, Checkpoint, Measures, RunSummary, SimulateOptions, simulate,
};
use crate::commands::sweep::{self, sweep_if};
use crate::configuration::Notes;
use crate::errors::{Error, Report};
use crate::files::{Input, Place, Safeguard};
use crate::supervision::warnings::{self, warn};
use crate::supervision::{Forecast, TileOptions, Watch};
use clap::{CommandFactory, Parser};
use clap_complete::Shell;
use lie_poisson_runs::PathEnsemble;
use serde::Serialize;
use std::fmt::{self, Display};
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Runs the program with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    let (done, json) = match Arguments::try_parse() {
        Ok(arguments) => {
            let json = arguments.json;
            if json {
                warnings::in_json();
            }
            (run(arguments), json)
        }
        Err(error) if error.use_stderr() => return refuse(error),
        // The user asked for help, or for the version.
        Err(help) => (print_help(&help), false),
    };
    match done {
        Err(error) if !error.is_closed_pipe() => told(&error, json),
        _ => ExitCode::SUCCESS,
    }
}

/// Prints what is wrong with the arguments. The exit code has to suffice where stderr is closed.
fn refuse(mut error: clap::Error) -> ExitCode {
    suggest_command(&mut error);
    if std::env::args_os().any(|argument| argument == "--json") {
        print_line(&Report::of_arguments(&error.render().to_string()));
    } else {
        let _ = print_fitted(&error, io::stderr().is_terminal(), io::stderr());
    }
    ExitCode::from(2)
}

fn run(Arguments { quiet, json, command }: Arguments) -> Result<(), Error> {
    let closing = Closing { begun: Instant::now(), json, quiet };
    match command {
        Command::Reproduce { out, end, step, replacing } => {
            let safeguard = Safeguard::new(Vec::new(), replacing.force);
            reproduce(&out, step, end, &watch(quiet, &safeguard))
                .and_then(|done| closing.print(&done, &Notes::default()))
        }
        Command::Simulate { top, out, replacing, dry_run: true, .. } => top
            .run(replacing, |config, _| simulate::dry_run(&config, &out))
            .and_then(|done| print(&done, json)),
        Command::Simulate {
            top,
            out,
            replacing,
            resume,
            restart,
            checkpoint_interval,
            check,
            balance,
            yes,
            ..
        } => {
            let resume = resume.as_ref().map(Option::as_deref);
            let (interval, measures) = (checkpoint_interval, Measures { check, balance });
            let begin = Begin { resume, restart, replacing, interval, measures, yes };
            let (summary, notes) = run_simulate(&top, &out, &begin, quiet)?;
            closing.end(&summary, &notes, &out)?;
            // The run is complete; there is nothing to resume.
            match summary.was_interrupted() {
                true => Err(Error::Interrupted { resume: None }),
                false => Ok(()),
            }
        }
        Command::Plot {
            run,
            out,
            replacing,
            sample,
            plane,
            every,
            fps,
            columns,
            against,
            trace,
        } => {
            let safeguard = Safeguard::new(vec![Input::File(run.clone())], replacing.force);
            let options = PlotOptions { sample, plane, every, fps, columns, against, trace };
            match out {
                Some(out) => plot(&run, &out, &options, &watch(quiet, &safeguard))
                    .and_then(|done| closing.print(&done, &Notes::default())),
                None => plot_as_text(&run, &options).and_then(|charts| print(&charts, json)),
            }
        }
        Command::Export { run, out, replacing, format, every } => {
            let safeguard = Safeguard::new(vec![Input::File(run.clone())], replacing.force);
            export(&run, &out, format, every, &watch(quiet, &safeguard))
                .and_then(|done| closing.print(&done, &Notes::default()))
        }
        Command::Compare { top, out, replacing, end } => top
            .noted(replacing, |config, safeguard| {
                compare(&config, &out, end, &watch(quiet, safeguard))
            })
            .and_then(|(done, notes)| closing.print(&done, &notes)),
        Command::Section { top, out, replacing, parts: Parts { dry_run: true, .. } } => top
            .run(replacing, |config, _| section::dry_run(&config, &out, top.threads))
            .and_then(|done| print(&done, json)),
        Command::Section { top, out, replacing, parts } => top
            .noted(replacing, |config, safeguard| {
                if !parts.resume {
                    confirm(&section::forecast(&config, &out)?, parts.yes)?;
                }
                section(&config, &out, &in_tiles(&top, parts, quiet, safeguard))
            })
            .and_then(|(done, notes)| closing.print(&done, &notes)),
        Command::Sweep { top, out, replacing, parts: Parts { dry_run: true, .. } } => top
            .run(replacing, |config, _| sweep::dry_run(&config, &out, top.threads))
            .and_then(|done| done.map_or(Ok(()), |done| print(&done, json))),
        Command::Sweep { top, out, replacing, parts } => top
            .noted(replacing, |config, safeguard| {
                let agree = |forecast: &Forecast| confirm(forecast, parts.yes);
                sweep_if(&config, &out, &in_tiles(&top, parts, quiet, safeguard), agree)
            })
            .and_then(|(done, notes)| done.map_or(Ok(()), |done| closing.print(&done, &notes))),
        Command::Animate { top, out, replacing } => top
            .noted(replacing, |config, safeguard| animate(config, &out, &watch(quiet, safeguard)))
            .and_then(|(done, notes)| closing.end(&done, &notes, &out)),
        Command::Bench { top, problem, only, tops } => top
            .noted(Replacing { force: false }, |config, _| {
                let threads = top.threads.unwrap_or(1);
                let options = BenchOptions { only, tops, threads };
                bench(&config, problem.as_deref(), options, quiet)
            })
            .and_then(|(done, notes)| {
                print(&Noted { summary: &done, notes: &notes }, json)?;
                closing.note(&notes);
                Ok(())
            }),
        Command::Report { top } => top
            .noted(Replacing { force: false }, |config, _| report(&config))
            .and_then(|(done, notes)| closing.print(&done, &notes)),
        Command::Events { top, out, replacing } => top
            .noted(replacing, |config, safeguard| events(&config, &out, &watch(quiet, safeguard)))
            .and_then(|(done, notes)| closing.end(&done, &notes, &out)),
        Command::Ensemble { top, out, replacing, paths, quantiles } => top
            .noted(replacing, |config, safeguard| {
                let paths = PathEnsemble { paths, quantiles };
                ensemble(&config, &paths, &out, &watch(quiet, safeguard))
            })
            .and_then(|(done, notes)| closing.end(&done, &notes, &out)),
        Command::Init { file, preset, map, kind, replacing } => match kind {
            Some(kind) => init_system(&kind, file.as_deref(), replacing.force),
            None => init(preset, map, file.as_deref(), replacing.force),
        },
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
    ///
    /// Where the numbers are on stdout, the summary for machines goes to stderr.
    fn end(
        &self,
        summary: &(impl Display + Serialize),
        notes: &Notes,
        out: &Path,
    ) -> Result<(), Error> {
        if self.json && Place::of(out)?.is_standard_output() {
            print_line(&Noted { summary, notes });
            return Ok(());
        }
        if self.json {
            return print(&Noted { summary, notes }, true);
        }
        self.say(&format!(": {summary}"), notes);
        Ok(())
    }

    /// Ends a command whose summary goes to stdout.
    fn print(&self, summary: &(impl Display + Serialize), notes: &Notes) -> Result<(), Error> {
        print(&Noted { summary, notes }, self.json)?;
        self.say("", notes);
        Ok(())
    }

    fn say(&self, what: &str, notes: &Notes) {
        if !(self.json || self.quiet) {
            let seconds = self.begun.elapsed().as_secs_f64();
            // The command has succeeded where stderr is closed, too.
            let _ = writeln!(io::stderr(), "heavytop: done{what}; {seconds:.2} s");
        }
        self.note(notes);
    }

    fn note(&self, notes: &Notes) {
        if !(self.json || self.quiet) {
            for note in notes.to_string().lines() {
                let _ = writeln!(io::stderr(), "heavytop: {note}");
            }
        }
    }
}

/// A summary with the notes on the configuration; as text it is the summary alone.
#[derive(Serialize)]
struct Noted<'a, S> {
    #[serde(flatten)]
    summary: &'a S,
    #[serde(flatten)]
    notes: &'a Notes,
}

impl<S: Display> Display for Noted<'_, S> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.summary.fmt(to)
    }
}

fn completions(shell: Shell) -> Result<(), Error> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "heavytop", &mut script);
    to_stdout(io::stdout().lock().write_all(&script))
}

/// The start of `simulate`, and how often it renews its checkpoint.
struct Begin<'a> {
    /// Whether to go on from a checkpoint, and from which one, if it is not that of the output.
    resume: Option<Option<&'a Path>>,
    restart: bool,
    replacing: Replacing,
    /// The time between checkpoints, s.
    interval: f64,
    /// What is measured of the whole run.
    measures: Measures,
    /// Whether not to ask before an output that is absurdly large.
    yes: bool,
}

/// Reads the checkpoint at a path, or else that of the output, unless there is none.
///
/// # Errors
/// If it cannot be read. If there is none beside the output, and no configuration either: the run that was meant is not
/// known.
fn checkpoint(top: &Top, out: &Path, path: Option<&Path>) -> Result<Option<Checkpoint>, Error> {
    let own = Place::of(out)?.beside("checkpoint");
    match path {
        None if !own.exists() && !top.is_default() => Ok(None),
        path => Checkpoint::read(path.unwrap_or(&own)).map(Some),
    }
}

fn run_simulate(
    top: &Top,
    out: &Path,
    begin: &Begin<'_>,
    quiet: bool,
) -> Result<(RunSummary, Notes), Error> {
    let Begin { resume, restart, replacing, interval, measures, yes } = *begin;
    let resume = resume.map(|path| checkpoint(top, out, path)).transpose()?.flatten();
    let range = "not negative, and at most 1e9";
    let interval = Duration::try_from_secs_f64(interval)
        .ok()
        .filter(|interval| interval.as_secs_f64() <= 1e9)
        .ok_or(Error::OutOfRange { name: "checkpoint-interval", range, value: interval })?;
    top.run(replacing, |config, safeguard| {
        let config = match &resume {
            // The checkpoint has its own configuration.
            Some(checkpoint) if top.is_default() => checkpoint.configuration().clone(),
            _ => config,
        };
        if resume.is_none() {
            confirm(&simulate::forecast(&config, out)?, yes)?;
        }
        let stop = Some(interrupted());
        let resume = resume.as_ref();
        let options =
            SimulateOptions { resume, restart, interval, stop, measures, quiet, safeguard };
        if let Some(warning) = config.body_warning() {
            warn(warning);
        }
        let summary = simulate(&config, out, &options)?;
        Ok((summary, config.notes()))
    })
}

/// Returns the options of a command that keeps its finished parts.
fn in_tiles<'a>(top: &Top, parts: Parts, quiet: bool, safeguard: &'a Safeguard) -> TileOptions<'a> {
    let (Parts { resume, restart, .. }, threads) = (parts, top.threads);
    TileOptions { resume, restart, stop: Some(interrupted()), threads, quiet, safeguard }
}

/// Returns the options of a command that keeps nothing when it is interrupted.
fn watch(quiet: bool, safeguard: &Safeguard) -> Watch<'_> {
    Watch { stop: Some(interrupted()), quiet, safeguard }
}

fn told(error: &Error, json: bool) -> ExitCode {
    if json {
        print_line(&Report::from(error));
    } else {
        // The exit code has to suffice where stderr is closed.
        let _ = writeln!(io::stderr(), "heavytop: {}", error.message());
    }
    error.exit_code().into()
}
