//! The command line.

use crate::Error;
use crate::animate::animate;
use crate::bench::{Options as BenchOptions, bench};
use crate::compare::compare;
use crate::config::Config;
use crate::help::{
    ANIMATE, ANIMATE_EXAMPLES, BENCH, BENCH_EXAMPLES, COMPARE, COMPARE_EXAMPLES,
    COMPLETIONS_EXAMPLES, EXIT_CODES, REPRODUCE, REPRODUCE_EXAMPLES, SECTION, SECTION_EXAMPLES,
    SIMULATE, SIMULATE_EXAMPLES, SWEEP, SWEEP_EXAMPLES,
};
use crate::preset::Preset;
use crate::reproduce::reproduce;
use crate::section::section;
use crate::simulate::{Checkpoint, Options, Summary, simulate};
use crate::sweep::sweep;
use crate::tiles::Options as InTiles;
use crate::watch::Watch;
use clap::{Args, CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use serde::Serialize;
use std::fmt::Display;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Simulates heavy tops with collective Lie–Poisson integrators.
///
/// The method is of T. Ohsawa, "Collective Heavy Top Dynamics", SIGMA 15 (2019) 083: a symplectic
/// scheme on T∗C², mapped to the phase space of the top, conserves the Casimirs f1 = |Γ|² and
/// f2 = Π·Γ exactly.
#[derive(Debug, Parser)]
#[command(name = "heavytop", version, after_long_help = EXIT_CODES)]
struct Arguments {
    /// Show no progress bar. (It shows on a terminal only, in long runs.)
    #[arg(long, global = true, display_order = 100)]
    quiet: bool,

    /// Print the summary as JSON, for machines.
    #[arg(long, global = true, display_order = 101)]
    json: bool,

    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Reproduce the paper's figures: Kovalevskaya's top with four integrators.
    #[command(long_about = REPRODUCE, after_long_help = REPRODUCE_EXAMPLES)]
    Reproduce {
        /// The folder for the figures and tables; made if it is not there.
        #[arg(long, value_name = "DIR", default_value = "figures")]
        out: PathBuf,
        /// The time to stop at, in seconds: a whole number of steps.
        #[arg(
            long,
            value_name = "SECONDS",
            default_value_t = 100.0,
            allow_negative_numbers = true
        )]
        end: f64,
        /// The time step, in seconds.
        #[arg(long, value_name = "SECONDS", default_value_t = 0.02, allow_negative_numbers = true)]
        step: f64,
    },
    /// Simulate a top and write its states and invariants.
    #[command(long_about = SIMULATE, after_long_help = SIMULATE_EXAMPLES)]
    Simulate {
        #[command(flatten)]
        top: Top,
        /// The file to write; its name ends in .csv, .npz (NumPy) or .parquet.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        /// Go on from FILE.checkpoint, which an interrupted run has left.
        #[arg(long, value_name = "CHECKPOINT")]
        resume: Option<PathBuf>,
        /// Start anew, and discard FILE.checkpoint if there is one.
        #[arg(long, conflicts_with = "resume")]
        restart: bool,
        /// Renew the checkpoint whenever so much time has passed, in seconds.
        #[arg(long, value_name = "SECONDS", default_value_t = 60.0, allow_negative_numbers = true)]
        checkpoint_interval: f64,
    },
    /// Measure work against precision, for every formulation and scheme.
    #[command(long_about = COMPARE, after_long_help = COMPARE_EXAMPLES)]
    Compare {
        #[command(flatten)]
        top: Top,
        /// The folder for the figure and the table; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
    },
    /// Draw a Poincaré section of a top.
    #[command(long_about = SECTION, after_long_help = SECTION_EXAMPLES)]
    Section {
        #[command(flatten)]
        top: Top,
        /// The folder for the figure and the table; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// Go on from the finished starts that an interrupted section has left in the folder.
        #[arg(long)]
        resume: bool,
        /// Start anew, and discard those starts if there are any.
        #[arg(long, conflicts_with = "resume")]
        restart: bool,
    },
    /// Follow many tops at once, and map what becomes of them.
    #[command(long_about = SWEEP, after_long_help = SWEEP_EXAMPLES)]
    Sweep {
        #[command(flatten)]
        top: Top,
        /// The folder for the table and the heat maps; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// Go on from the finished tiles that an interrupted sweep has left in the folder.
        #[arg(long)]
        resume: bool,
        /// Start anew, and discard those tiles if there are any.
        #[arg(long, conflicts_with = "resume")]
        restart: bool,
    },
    /// Show a top in motion, on a page for a browser.
    #[command(long_about = ANIMATE, after_long_help = ANIMATE_EXAMPLES)]
    Animate {
        #[command(flatten)]
        top: Top,
        /// The page to write; its name ends in .html.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
    },
    /// Time the integrators on one top and on many.
    #[command(long_about = BENCH, after_long_help = BENCH_EXAMPLES)]
    Bench {
        #[command(flatten)]
        top: Top,
        /// The tops of this file, with references, instead of the configured top and tops about it.
        #[arg(long, value_name = "FILE")]
        problem: Option<PathBuf>,
        /// Time only integrators with this in their names.
        #[arg(long, value_name = "PART")]
        only: Option<String>,
        /// The number of tops in the ensemble.
        #[arg(long, value_name = "COUNT", default_value_t = 10_000, allow_negative_numbers = true)]
        tops: u64,
        /// The number of threads for the ensemble.
        #[arg(long, value_name = "COUNT", default_value_t = 1, allow_negative_numbers = true)]
        threads: usize,
    },
    /// Print the completions of a shell, to be put where it looks for them.
    #[command(after_long_help = COMPLETIONS_EXAMPLES)]
    Completions {
        /// The shell.
        shell: Shell,
    },
}

/// Which top, and how to follow it.
#[derive(Debug, Args)]
struct Top {
    /// The configuration, in TOML; what it leaves out is as in the preset.
    config: Option<PathBuf>,
    /// A top by name; without it the paper's Kovalevskaya top.
    #[arg(long)]
    preset: Option<Preset>,
}

impl Top {
    fn is_default(&self) -> bool {
        self.config.is_none() && self.preset.is_none()
    }

    fn config(&self) -> Result<Config, Error> {
        Config::load(self.preset, self.config.as_deref())
    }
}

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

/// Prints a summary, as text or as JSON.
fn print(summary: &(impl Display + Serialize), json: bool) -> Result<(), Error> {
    let written = if json {
        serde_json::to_string_pretty(summary).map_err(Into::into)
    } else {
        Ok(summary.to_string())
    };
    to_stdout(written.and_then(|text| writeln!(io::stdout().lock(), "{text}")))
}

fn completions(shell: Shell) -> Result<(), Error> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "heavytop", &mut script);
    to_stdout(io::stdout().lock().write_all(&script))
}

/// The outcome of what was written to stdout, after the rest of it.
fn to_stdout(written: io::Result<()>) -> Result<(), Error> {
    match written.and_then(|()| io::stdout().flush()) {
        // Whoever closed the pipe has read enough.
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(Error::Write { path: "standard output".into(), source })
        }
        _ => Ok(()),
    }
}

/// From where `simulate` begins, and how often it renews its checkpoint.
struct Begin<'a> {
    resume: Option<&'a Path>,
    restart: bool,
    /// s
    interval: f64,
}

fn run_simulate(top: &Top, out: &Path, begin: &Begin<'_>, quiet: bool) -> Result<Summary, Error> {
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
    simulate(&config, out, &Options { resume: resume.as_ref(), restart, interval, stop, quiet })
}

/// How a command is accompanied whose finished parts are kept.
fn in_tiles(resume: bool, restart: bool, quiet: bool) -> InTiles<'static> {
    InTiles { resume, restart, stop: Some(interrupted()), quiet }
}

/// What accompanies a command that keeps nothing when it is interrupted.
fn watch(quiet: bool) -> Watch<'static> {
    Watch { stop: Some(interrupted()), quiet }
}

/// Signals that come together are one: launchers send them to a process and to its group.
const TOGETHER: Duration = Duration::from_millis(500);

/// What Ctrl-C, and the signals that ask a program to end, make true. A second one, later, ends it at
/// once.
fn interrupted() -> &'static AtomicBool {
    static INTERRUPTED: AtomicBool = AtomicBool::new(false);
    let mut first: Option<Instant> = None;
    // Where there is no handler such a signal ends the program, as ever.
    let _ = ctrlc::set_handler(move || {
        if first.get_or_insert_with(Instant::now).elapsed() > TOGETHER {
            std::process::exit(130);
        }
        INTERRUPTED.store(true, Ordering::Relaxed);
    });
    &INTERRUPTED
}

fn report(error: &Error) -> ExitCode {
    // Where stderr is closed the exit code has to do.
    let _ = writeln!(io::stderr(), "heavytop: {}", error.message());
    error.exit_code().into()
}
