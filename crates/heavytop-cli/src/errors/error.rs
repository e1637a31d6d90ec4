//! What can go wrong in a command, and the exit codes.

use super::checkpoint_error::CheckpointError;
use super::sweep_error::SweepError;
use crate::vocabulary::brief::{number, text};
use crate::vocabulary::{Formulation, Scheme};
use collective_integrators::{
    EventError, IntegrationError, RunError, SchemeError, VariationalError,
};
use heavytop::{SectionError, TopError};
use momentum_map::LiftError;
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a command did not do what it was asked. [`Error::message`] has the causes too.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// The configuration file could not be read.
    #[error("cannot read the configuration {}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The configuration file is not TOML, or has unknown keys or wrong types.
    #[error("{}, line {line}, column {column}: {message}", path.display())]
    Configuration {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// What is wrong there.
        message: String,
    },
    /// The configuration has no TOML.
    #[error("the configuration cannot be written as TOML")]
    Unwritable(#[source] toml::ser::Error),
    /// The run cannot go on from a checkpoint.
    #[error("cannot go on from {}", path.display())]
    Checkpoint {
        /// The checkpoint.
        path: PathBuf,
        /// Why.
        source: CheckpointError,
    },
    /// A saved state is not one of this experiment's integrator.
    #[error("the saved state has {found} numbers, that of the integrator {expected}")]
    SavedState {
        /// How many the integrator's has.
        expected: usize,
        /// How many it has.
        found: usize,
    },
    /// No top has these parameters.
    #[error("[body]")]
    Body(#[source] TopError),
    /// Γ(0) is not a unit vector.
    #[error("[initial]")]
    Vertical(#[source] TopError),
    /// No run can start from the initial state.
    #[error("[initial]")]
    Start(#[from] RunError),
    /// The formulation does not have the scheme.
    #[error(
        "{} has no scheme {}; it has {}", formulation.name(), scheme.name(), scheme_names(*formulation)
    )]
    NoSuchPair {
        /// The formulation.
        formulation: Formulation,
        /// The scheme.
        scheme: Scheme,
    },
    /// The formulation has no attitude.
    #[error(
        "{} has no attitude: its six equations do not determine it; collective, reduced and \
         splitting have one", formulation.name()
    )]
    NoAttitude {
        /// The formulation.
        formulation: Formulation,
    },
    /// The scheme could not be made.
    #[error("{scheme}")]
    Scheme {
        /// Its name.
        scheme: &'static str,
        /// Why.
        source: SchemeError,
    },
    /// A number is out of its range.
    #[error("{name} must be {range}, got {}", number(*value))]
    OutOfRange {
        /// The number.
        name: &'static str,
        /// Its range.
        range: &'static str,
        /// Its value.
        value: f64,
    },
    /// The body turns too far in one step for any method to mean anything.
    #[error(
        "a step of {} s turns the body by about {angle:.3e} rad; it must be at most {most}",
        number(*step)
    )]
    AbsurdStep {
        /// The step, s.
        step: f64,
        /// The angle, rad.
        angle: f64,
        /// The most that is allowed, rad.
        most: f64,
    },
    /// The run has more steps than a lifetime has.
    #[error(
        "the run would take {steps:e} steps, more than {most:e}: raise the step or lower the end"
    )]
    TooManySteps {
        /// The number of steps.
        steps: f64,
        /// The most that is allowed.
        most: f64,
    },
    /// The end is not a whole number of steps.
    #[error(
        "end = {} is not a whole number of steps of {}; the nearest ends are {} and {}",
        number(*end), number(*step), number(*before), number(*after)
    )]
    BrokenStep {
        /// The end asked for.
        end: f64,
        /// The step.
        step: f64,
        /// The last end before it that can be reached.
        before: f64,
        /// The first end after it that can be reached.
        after: f64,
    },
    /// The output's name asks for a format that there is not.
    #[error("cannot write {}: the name must end in .csv, .npz or .parquet", path.display())]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// The output's name is not that of a page.
    #[error("cannot write {}: the name must end in .html", path.display())]
    NoPage {
        /// The file.
        path: PathBuf,
    },
    /// An output file or folder could not be made.
    #[error("cannot create {}", path.display())]
    Create {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Writing failed while the numbers came in.
    #[error("cannot write {}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The numbers failed: a stage equation did not converge, or a state is not finite.
    #[error("{formulation}, {scheme}")]
    Integration {
        /// The formulation's name.
        formulation: &'static str,
        /// The scheme's name.
        scheme: &'static str,
        /// The step, the time and the reason.
        source: IntegrationError,
    },
    /// An integrator that was to be timed failed.
    #[error("{name}")]
    Timed {
        /// The integrator.
        name: String,
        /// The step, the time and the reason.
        source: IntegrationError,
    },
    /// No integrator has this in its name.
    #[error("no integrator has `{}` in its name; there are {}", text(only), names.join(", "))]
    NoContestant {
        /// What was asked for.
        only: String,
        /// Their names.
        names: Vec<String>,
    },
    /// The system refuses so many threads.
    #[error("cannot start {threads} thread(s)")]
    Threads {
        /// Their number.
        threads: usize,
        /// Why.
        source: rayon::ThreadPoolBuildError,
    },
    /// The system refuses threads for what is done in parallel.
    #[error("cannot start threads, of which RAYON_NUM_THREADS sets the number")]
    Workers(#[source] rayon::ThreadPoolBuildError),
    /// There is no such section.
    #[error("[section]")]
    Section(#[from] SectionError),
    /// The motion through a start of a section could not be followed.
    #[error("{formulation}, {scheme}, start {start}")]
    Crossing {
        /// The formulation's name.
        formulation: &'static str,
        /// The scheme's name.
        scheme: &'static str,
        /// The number of the start, from 1.
        start: usize,
        /// The step, the time and the reason.
        source: EventError,
    },
    /// There is no such sweep.
    #[error("[sweep]")]
    Sweep(#[from] SweepError),
    /// No top of a sweep could be followed.
    #[error("all {tops} tops failed; the first: {first}")]
    AllFailed {
        /// How many there are.
        tops: u64,
        /// Why the first did.
        first: String,
    },
    /// Tangent vectors of a top in a sweep have no direction any more.
    #[error(transparent)]
    Tangent(VariationalError),
    /// There is what an unfinished run has kept.
    #[error(
        "{} is of an interrupted run: go on with {resume}, or discard it with --restart", path.display()
    )]
    Unfinished {
        /// Its checkpoint, or the folder of its tiles.
        path: PathBuf,
        /// The argument by which it goes on.
        resume: String,
    },
    /// What an interrupted run has finished cannot be read.
    #[error("cannot read {}", path.display())]
    Tile {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A tile that should have been finished is not there.
    #[error(
        "tile {tile} is missing in {}, which must be on a file system that all processes see",
        folder.display()
    )]
    MissingTile {
        /// Its number.
        tile: u64,
        /// The folder of the tiles.
        folder: PathBuf,
    },
    /// Two reference solutions differ.
    #[error(
        "the reference solution is certain to {uncertainty:.1e} of its size only, not to {most:e}: \
         lower [integrator] step, or the end"
    )]
    Reference {
        /// How far they are from each other, relative to their size.
        uncertainty: f64,
        /// How far they may be.
        most: f64,
    },
    /// A figure could not be drawn.
    #[error("cannot draw the figure: {0}")]
    Figure(String),
    /// A run was stopped.
    #[error("interrupted{}", .resume.as_deref().map_or_else(String::new, resumption))]
    Interrupted {
        /// The argument by which it goes on, if it can.
        resume: Option<String>,
    },
    /// A run failed for want of something outside it, and can go on.
    #[error("the run can go on by the same command with {resume}")]
    Resumable {
        /// The argument by which it does.
        resume: String,
        /// Why it failed.
        source: Box<Error>,
    },
    /// A run failed, and what it had computed was kept.
    #[error("what was computed until the run failed is in {}", partial.display())]
    Kept {
        /// Where.
        partial: PathBuf,
        /// Why it failed.
        source: Box<Error>,
    },
}

impl From<LiftError> for Error {
    fn from(error: LiftError) -> Self {
        Self::Start(error.into())
    }
}

impl Error {
    /// That a file cannot be created, when it is too late to refuse the request.
    pub(crate) fn too_late(self) -> Self {
        match self {
            Self::Create { path, source } => Self::Write { path, source },
            other => other,
        }
    }

    /// 2 if the request is wrong, and nothing was written; 1 if it failed underway; 130 if it was
    /// interrupted, as shells have it.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Reference { .. }
            | Self::Write { .. }
            | Self::Integration { .. }
            | Self::Timed { .. }
            | Self::Crossing { .. }
            | Self::AllFailed { .. }
            | Self::Tangent(_)
            | Self::Workers(_)
            | Self::Tile { .. }
            | Self::MissingTile { .. }
            | Self::Figure(_)
            | Self::Resumable { .. }
            | Self::Kept { .. } => 1,
            Self::Interrupted { .. } => 130,
            _ => 2,
        }
    }
}

/// That a run goes on with this argument.
pub(super) fn resumption(argument: &str) -> String {
    format!("; go on by the same command with {argument}")
}

fn scheme_names(formulation: Formulation) -> String {
    formulation.schemes().map(Scheme::name).collect::<Vec<_>>().join(", ")
}
