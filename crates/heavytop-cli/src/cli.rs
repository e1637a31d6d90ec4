//! The command line.

use crate::Error;
use crate::animate::animate;
use crate::compare::compare;
use crate::help::{
    ANIMATE, ANIMATE_EXAMPLES, COMPARE, COMPARE_EXAMPLES, EXIT_CODES, REPRODUCE,
    REPRODUCE_EXAMPLES, SECTION, SECTION_EXAMPLES, SIMULATE, SIMULATE_EXAMPLES,
};
use crate::reproduce::reproduce;
use crate::section::section;
use crate::simulate::simulate;
use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

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
        /// The configuration, in TOML. Without it the paper's Kovalevskaya top is run.
        config: Option<PathBuf>,
        /// The file to write; its name ends in .csv.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
    },
    /// Measure work against precision, for every formulation and scheme.
    #[command(long_about = COMPARE, after_long_help = COMPARE_EXAMPLES)]
    Compare {
        /// The configuration, in TOML, as of simulate. Without it the paper's Kovalevskaya top is run.
        config: Option<PathBuf>,
        /// The folder for the figure and the table; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
    },
    /// Draw a Poincaré section of a top.
    #[command(long_about = SECTION, after_long_help = SECTION_EXAMPLES)]
    Section {
        /// The configuration, in TOML, as of simulate. Without it the paper's Kovalevskaya top is run.
        config: Option<PathBuf>,
        /// The folder for the figure and the table; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
    },
    /// Show a top in motion, on a page for a browser.
    #[command(long_about = ANIMATE, after_long_help = ANIMATE_EXAMPLES)]
    Animate {
        /// The configuration, in TOML, as of simulate. Without it the paper's Kovalevskaya top is run.
        config: Option<PathBuf>,
        /// The page to write; its name ends in .html.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
    },
}

/// Runs the program with the arguments of the process.
#[must_use]
pub fn main() -> ExitCode {
    let Arguments { quiet, command } = Arguments::parse();
    let done = match command {
        Command::Reproduce { out, end, step } => reproduce(&out, step, end, quiet),
        Command::Simulate { config, out } => simulate(config.as_deref(), &out, quiet),
        Command::Compare { config, out } => compare(config.as_deref(), &out, quiet),
        Command::Section { config, out } => section(config.as_deref(), &out, quiet),
        Command::Animate { config, out } => animate(config.as_deref(), &out, quiet),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => report(&error),
    }
}

fn report(error: &Error) -> ExitCode {
    use std::io::Write;
    // Where stderr is closed the exit code has to do.
    let _ = writeln!(std::io::stderr(), "heavytop: {error}");
    error.exit_code().into()
}
