//! The arguments of the command line.

use super::beginnings::map_tables::MapTable;
use super::help::{
    ANIMATE, ANIMATE_EXAMPLES, BENCH, BENCH_EXAMPLES, COMPARE, COMPARE_EXAMPLES,
    COMPLETIONS_EXAMPLES, ENSEMBLE, ENSEMBLE_EXAMPLES, EVENTS, EVENTS_EXAMPLES, EXIT_CODES, EXPORT,
    EXPORT_EXAMPLES, INIT_EXAMPLES, MAN_EXAMPLES, PLOT, PLOT_EXAMPLES, REPORT, REPORT_EXAMPLES,
    REPRODUCE, REPRODUCE_EXAMPLES, SECTION, SECTION_EXAMPLES, SIMULATE, SIMULATE_EXAMPLES, SWEEP,
    SWEEP_EXAMPLES,
};
use crate::commands::export::ExportFormat;
use crate::configuration::{Config, Notes, Preset};
use crate::errors::Error;
use crate::files::Safeguard;
use crate::reading::Sources;
use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;
use std::path::PathBuf;

/// Simulates heavy tops with collective Lie–Poisson integrators.
///
/// The method is of T. Ohsawa, "Collective Heavy Top Dynamics", SIGMA 15 (2019) 083: a symplectic
/// scheme on T∗C², mapped to the phase space of the top, conserves the Casimirs f1 = |Γ|² and
/// f2 = Π·Γ exactly.
#[derive(Debug, Parser)]
#[command(name = "heavytop", version, after_long_help = EXIT_CODES)]
pub(super) struct Arguments {
    /// Show no progress bar and no closing line. (The bar shows on a terminal only, in long runs.)
    #[arg(long, global = true, display_order = 100)]
    pub(super) quiet: bool,

    /// Print the summary as JSON, for machines; warnings and errors too, one a line, on stderr.
    #[arg(long, global = true, display_order = 101)]
    pub(super) json: bool,

    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Reproduce the paper's figures: Kovalevskaya's top with four integrators.
    #[command(long_about = REPRODUCE, after_long_help = REPRODUCE_EXAMPLES)]
    Reproduce {
        /// The folder for the figures and tables; made if it is not there.
        #[arg(long, value_name = "DIR", default_value = "figures")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
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
        /// The file to write; its name ends in .csv, .npz (NumPy) or .parquet; - is standard output, in CSV.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
        /// Go on from FILE.checkpoint, which an interrupted run has left, or from another CHECKPOINT.
        #[arg(long, value_name = "CHECKPOINT", num_args = 0..=1)]
        resume: Option<Option<PathBuf>>,
        /// Start anew, and discard FILE.checkpoint if there is one.
        #[arg(long, conflicts_with = "resume")]
        restart: bool,
        /// Renew the checkpoint whenever so much time has passed, in seconds.
        #[arg(long, value_name = "SECONDS", default_value_t = 60.0, allow_negative_numbers = true)]
        checkpoint_interval: f64,
        /// Make the run again with half the step and with twice the step, and say its error and order.
        #[arg(long, conflicts_with = "dry_run")]
        check: bool,
        /// Say how forces change the conserved quantities, what they supply to them, and what the method adds.
        #[arg(long, conflicts_with = "dry_run")]
        balance: bool,
        /// Write nothing; print the rows and the size of the output, and an estimate of the time.
        #[arg(long, conflicts_with = "resume")]
        dry_run: bool,
        /// Do not ask before a run that needs more room than the disk has, or more than 100 GB.
        #[arg(long)]
        yes: bool,
    },
    /// Measure work against precision, for every formulation and scheme.
    #[command(long_about = COMPARE, after_long_help = COMPARE_EXAMPLES)]
    Compare {
        #[command(flatten)]
        top: Top,
        /// The folder for the figure and the table; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
        /// The end of the interval, in seconds: a whole number of configured steps.
        #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
        end: Option<f64>,
    },
    /// Tell the precession, nutation and spin of a top, beside the formulas of textbooks.
    #[command(long_about = REPORT, after_long_help = REPORT_EXAMPLES)]
    Report {
        #[command(flatten)]
        top: Top,
    },
    /// Find when functions of the state pass zero along a run.
    #[command(long_about = EVENTS, after_long_help = EVENTS_EXAMPLES)]
    Events {
        #[command(flatten)]
        top: Top,
        /// The table to write; its name ends in .csv; - is standard output.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
    },
    /// Follow many paths of a motion with noise, and write means, deviations and quantiles.
    #[command(long_about = ENSEMBLE, after_long_help = ENSEMBLE_EXAMPLES)]
    Ensemble {
        #[command(flatten)]
        top: Top,
        /// The table to write; its name ends in .csv; - is standard output.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
        /// The number of paths, at least 2.
        #[arg(long, value_name = "NUMBER", default_value_t = 1000)]
        paths: u64,
        /// The probabilities of the quantiles, between 0 and 1.
        #[arg(long, value_name = "P", value_delimiter = ',', default_value = "0.05,0.5,0.95")]
        quantiles: Vec<f64>,
    },
    /// Draw a Poincaré section of a top.
    #[command(long_about = SECTION, after_long_help = SECTION_EXAMPLES)]
    Section {
        #[command(flatten)]
        top: Top,
        /// The folder for the figure and the table; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
        #[command(flatten)]
        parts: Parts,
    },
    /// Follow many tops, or motions of a system, at once, and map what becomes of them.
    #[command(long_about = SWEEP, after_long_help = SWEEP_EXAMPLES)]
    Sweep {
        #[command(flatten)]
        top: Top,
        /// The folder for the table and the pictures; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
        #[command(flatten)]
        parts: Parts,
    },
    /// Show a top in motion, on a page for a browser.
    #[command(long_about = ANIMATE, after_long_help = ANIMATE_EXAMPLES)]
    Animate {
        #[command(flatten)]
        top: Top,
        /// The page to write; its name ends in .html; - is standard output.
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
    },
    /// Draw a run: vortices, spins, a fluid, or the coordinates against time.
    #[command(long_about = PLOT, after_long_help = PLOT_EXAMPLES)]
    Plot {
        /// The run: an archive FILE.npz of simulate.
        run: PathBuf,
        /// The picture to write; its name ends in .png or .svg, or in .gif for a film; without it
        /// columns are drawn in the terminal.
        #[arg(long, value_name = "FILE")]
        out: Option<PathBuf>,
        #[command(flatten)]
        replacing: Replacing,
        /// The number of the sample that is drawn, from 0; without it the last one.
        #[arg(long, value_name = "NUMBER")]
        sample: Option<usize>,
        /// The index along the third axis of the plane that is drawn; without it the middle one.
        #[arg(long, value_name = "INDEX")]
        plane: Option<usize>,
        /// Make a frame of a film from every N-th sample; without it there are at most 200 frames.
        #[arg(long, value_name = "N")]
        every: Option<usize>,
        /// The frames of a film per second, 1 to 50; without it 20.
        #[arg(long, value_name = "F")]
        fps: Option<u32>,
        /// Draw only these columns or arrays of the run, with a panel for each array or unit.
        #[arg(long, value_name = "NAMES", value_delimiter = ',')]
        columns: Vec<String>,
        /// Draw the columns against this one instead of t.
        #[arg(long, value_name = "NAME")]
        against: Option<String>,
        /// Draw the track of the direction of this vector on the sphere.
        #[arg(long, value_name = "ARRAY")]
        trace: Option<String>,
    },
    /// Write the vectors of a run for ParaView, OOMMF or Ubermag.
    #[command(long_about = EXPORT, after_long_help = EXPORT_EXAMPLES)]
    Export {
        /// The run: an archive FILE.npz of simulate, or another with t and arrays of samples.
        run: PathBuf,
        /// The folder for the files; made if it is not there.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        #[command(flatten)]
        replacing: Replacing,
        /// The format: vti for ParaView, ovf for OOMMF and Ubermag.
        #[arg(long, value_enum)]
        format: ExportFormat,
        /// Write every n-th sample, and the last one.
        #[arg(long, value_name = "N", default_value_t = 1)]
        every: u64,
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
    },
    /// Write a configuration with comments, to begin with.
    #[command(after_long_help = INIT_EXAMPLES)]
    Init {
        /// The file to write; without it, or with -, the text goes to standard output.
        file: Option<PathBuf>,
        #[command(flatten)]
        replacing: Replacing,
        /// A top by name; without it the paper's Kovalevskaya top.
        #[arg(long)]
        preset: Option<Preset>,
        /// Begin a configuration of many motions, for this command.
        #[arg(long = "for", value_enum, value_name = "COMMAND")]
        map: Option<MapTable>,
        /// A system by its name, such as spin-lattice, or one with forces, stochastic-rigid-body or driven-top.
        #[arg(long, value_name = "NAME", conflicts_with_all = ["preset", "map"])]
        kind: Option<String>,
    },
    /// Print the manual page of the program, or of a command.
    #[command(after_long_help = MAN_EXAMPLES)]
    Man {
        /// The command whose page is printed, instead of that of the program.
        command: Option<String>,
    },
    /// Print the completions of a shell, to be put where it looks for them.
    #[command(after_long_help = COMPLETIONS_EXAMPLES)]
    Completions {
        /// The shell whose completions are printed.
        shell: Shell,
    },
}

/// Which existing files a command replaces.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct Replacing {
    /// Replace files that the program has not written, too; never those that the command reads.
    #[arg(long)]
    pub(super) force: bool,
}

/// How to begin a command that keeps its finished parts.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct Parts {
    /// Go on from the finished parts that an interrupted run has left in the folder.
    #[arg(long)]
    pub(super) resume: bool,
    /// Start anew, and discard those parts if there are any.
    #[arg(long, conflicts_with = "resume")]
    pub(super) restart: bool,
    /// Write nothing; print the rows and the size of the output, and an estimate of the time.
    #[arg(long, conflicts_with = "resume")]
    pub(super) dry_run: bool,
    /// Do not ask before a run that needs more room than the disk has, or more than 100 GB.
    #[arg(long)]
    pub(super) yes: bool,
}

/// Which top, and how to follow it.
#[derive(Debug, Args)]
pub(super) struct Top {
    /// The configuration, in TOML; - is standard input; what it leaves out is as in the preset.
    config: Option<PathBuf>,
    /// A top by name; without it the paper's Kovalevskaya top.
    #[arg(long)]
    preset: Option<Preset>,
    /// Set a key of the configuration, over the file and the preset; may be given several times.
    ///
    /// A name needs no quotation marks: --set integrator.scheme=gauss-4. An index sets one number of a vector: --set
    /// body.inertia[2]=1.5.
    #[arg(long = "set", value_name = "TABLE.KEY=VALUE")]
    assignments: Vec<String>,
    /// The number of threads for section, sweep and bench; the other commands need one.
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true)]
    pub(super) threads: Option<usize>,
}

impl Top {
    pub(super) fn is_default(&self) -> bool {
        self.config.is_none() && self.preset.is_none() && self.assignments.is_empty()
    }

    /// Runs a command as [`run`](Self::run) does, and returns its outcome with the notes on the configuration.
    pub(super) fn noted<T>(
        &self,
        replacing: Replacing,
        command: impl FnOnce(Config, &Safeguard) -> Result<T, Error>,
    ) -> Result<(T, Notes), Error> {
        self.run(replacing, |config, safeguard| {
            let notes = config.notes();
            command(config, safeguard).map(|done| (done, notes))
        })
    }

    /// Runs a command with the configuration, and with the safeguard of the files that were read. A refusal quotes the
    /// line of the key at fault.
    pub(super) fn run<T>(
        &self,
        replacing: Replacing,
        command: impl FnOnce(Config, &Safeguard) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let sources = Sources::read(self.preset, self.config.as_deref(), &self.assignments)?;
        let safeguard = Safeguard::new(sources.inputs().to_vec(), replacing.force);
        command(sources.config().clone(), &safeguard).map_err(|error| sources.locate(error))
    }
}
