//! The errors of the commands.

use super::parts::checkpoint_error::CheckpointError;
use super::parts::field_file_error::FieldFileError;
use super::parts::input_file_error::InputFileError;
use super::parts::sweep_error::SweepError;
use super::parts::system_table_error::SystemTableError;
use super::quotation::Quotation;
use crate::vocabulary::brief::{number, text};
use crate::vocabulary::suggestion::suggestion;
use collective_integrators::{EventError, RunError, VariationalError};
use heavytop::methods::{Formulation, MethodError};
use heavytop::{SectionError, TopError};
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_formulas::FormulaError;
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// The reason why a command failed. [`Error::message`] adds the causes.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// The configuration file could not be read.
    #[error("cannot read the configuration {}", path.display())]
    Read {
        /// The path of the file.
        path: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// The file of the structure constants could not be read.
    #[error("[system] structure_constants: cannot read {}", path.display())]
    ReadTable {
        /// The path of the file.
        path: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// A file has not the arrays that are needed.
    #[error("{}", path.display())]
    FieldFile {
        /// The path of the file.
        path: PathBuf,
        /// What is wrong with it.
        source: Box<FieldFileError>,
    },
    /// A file has not the table of an input.
    #[error("[inputs.{name}] {}", path.display())]
    InputFile {
        /// The name of the input.
        name: String,
        /// The path of the file.
        path: PathBuf,
        /// What is wrong with it.
        source: Box<InputFileError>,
    },
    /// CSV and Parquet would have too many columns.
    #[error(
        "{format} has at most {most} columns here, and the run has {columns}: write an archive of arrays, FILE.npz"
    )]
    TooWide {
        /// The name of the format.
        format: String,
        /// The number of columns of the run.
        columns: usize,
        /// The largest number of columns.
        most: usize,
    },
    /// The name of a picture has another ending.
    #[error("{} is no picture: its name must end in .png, .svg or .gif", path.display())]
    NoPicture {
        /// The path of the picture.
        path: PathBuf,
    },
    /// There is no chart in the terminal of what is asked for.
    #[error(
        "{what} cannot be drawn in a terminal: name a picture with --out, such as --out run.png"
    )]
    NeedsPicture {
        /// What is asked for.
        what: &'static str,
    },
    /// A picture that shows a whole run would be a film.
    #[error(
        "{} would be a film, and the picture shows the whole run at once: its name must end in .png or .svg",
        path.display()
    )]
    NoFilm {
        /// The path of the film.
        path: PathBuf,
    },
    /// An option of a picture is of another kind of picture.
    #[error("--{option} is for {kind}")]
    OtherPicture {
        /// The name of the option.
        option: &'static str,
        /// The kind of picture that has the option, and the endings of its name.
        kind: &'static str,
    },
    /// The configuration is not TOML, or has an unknown key or a wrong type.
    #[error("{0}")]
    Misread(String),
    /// A value of the configuration is wrong, and is quoted.
    #[error("{quotation}")]
    Quoted {
        /// The place of the value, and the line that contains it.
        quotation: Box<Quotation>,
        /// The error of the value.
        source: Box<Error>,
    },
    /// An assignment on the command line is wrong.
    #[error("--set needs table.key=value, got `{}`: {reason}", text(assignment))]
    Assignment {
        /// The text of the assignment.
        assignment: String,
        /// The reason why the assignment is wrong.
        reason: &'static str,
    },
    /// An argument of the command line is wrong.
    #[error("--{name}")]
    Argument {
        /// The name of the argument.
        name: &'static str,
        /// The reason why the argument is wrong.
        source: Box<Error>,
    },
    /// The output would be absurdly large, and nobody has agreed to it.
    #[error("the run would write about {room}, and {free}: {remedy}, or agree with --yes")]
    Large {
        /// The room that the run needs.
        room: String,
        /// The room that there is, if it is known.
        free: String,
        /// How to make the output smaller.
        remedy: &'static str,
    },
    /// A file exists that the program has not written, and would have to be replaced.
    #[error(
        "{} exists, and is not overwritten: it is no {kind}; choose another name, or replace it with --force",
        path.display()
    )]
    Exists {
        /// The path of the file.
        path: PathBuf,
        /// The kind of file that would be replaced.
        kind: String,
    },
    /// An output, or a file that is written on the way to it, is a file that the command reads.
    #[error("cannot write {}: it is {input}, which this command reads; choose another name", path.display())]
    OutputIsInput {
        /// The path of the output.
        path: PathBuf,
        /// The name of the input.
        input: String,
    },
    /// The output of a command that writes several files is standard output.
    #[error(
        "--out - is standard output, and this command writes several files: name a folder, such as ./-"
    )]
    FolderIsStream,
    /// The program has no command of this name.
    #[error(
        "there is no command `{}`; there are {}{}",
        text(name), names.join(", "), suggestion(name, names.iter().map(String::as_str))
    )]
    NoCommand {
        /// The name that was asked for.
        name: String,
        /// The names of all commands.
        names: Vec<String>,
    },
    /// A file of tops has a wrong line.
    #[error("{}, line {line}, column {column}: {message}", path.display())]
    Configuration {
        /// The path of the file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// The message about that place in the text.
        message: String,
    },
    /// The configuration cannot be written as TOML.
    #[error("the configuration cannot be written as TOML")]
    Unwritable(#[source] toml::ser::Error),
    /// The run cannot continue from a checkpoint.
    #[error("cannot go on from {}", path.display())]
    Checkpoint {
        /// The path of the checkpoint.
        path: PathBuf,
        /// The reason why the run cannot continue.
        source: CheckpointError,
    },
    /// No top has these parameters.
    #[error("[body]")]
    Body(#[source] TopError),
    /// Γ(0) is not a unit vector.
    #[error("[initial]")]
    Vertical(#[source] TopError),
    /// The top cannot have the initial angular momentum.
    #[error("[initial]")]
    Spin(#[source] TopError),
    /// Moments about the centre of mass are given without its distance, or without the mass.
    #[error(
        "[body] inertia_about = \"center-of-mass\" needs mass and length, for the moments about the support"
    )]
    CentralMoments,
    /// There is an azimuth of Γ(0), but no inclination.
    #[error("[initial] azimuth needs inclination: the two give the vertical")]
    AzimuthAlone,
    /// The height of the centre of mass is asked for, and its distance from the support is not known.
    #[error("the column height needs the distance from the support to the centre of mass")]
    UnknownLength,
    /// A column needs the attitude, which the formulation does not determine.
    #[error("the column {column} needs the attitude, which {formulation} does not determine")]
    ColumnOfAttitude {
        /// The name of the column.
        column: &'static str,
        /// The formulation.
        formulation: Formulation,
    },
    /// No run can start from the initial state.
    #[error("[initial]")]
    Start(#[from] RunError),
    /// There is no integrator of the formulation and the scheme.
    #[error(transparent)]
    Method(MethodError),
    /// There is no such run, or it failed.
    #[error(transparent)]
    Run(lie_poisson_runs::RunFailure),
    /// A number is out of its range.
    #[error("{} must be {range}, got {}", without_table(name), number(*value))]
    OutOfRange {
        /// The key of the number in the configuration with its table, such as `output.every`, or the name of an argument.
        name: &'static str,
        /// The range of allowed values, in words.
        range: &'static str,
        /// The value of the number.
        value: f64,
    },
    /// A section would have too many points.
    #[error("starts × crossings must be at most {most:e}, got {}", number(*points))]
    TooManyPoints {
        /// The number of points.
        points: f64,
        /// The largest number of points allowed.
        most: f64,
    },
    /// The ending of the output's name stands for no format.
    #[error("cannot write {}: the name must end in .csv, .npz or .parquet", path.display())]
    Format {
        /// The path of the output.
        path: PathBuf,
    },
    /// The output's name does not end in `.csv`.
    #[error("cannot write {}: the name must end in .csv", path.display())]
    NoTable {
        /// The path of the output.
        path: PathBuf,
    },
    /// The output's name does not end in `.html`.
    #[error("cannot write {}: the name must end in .html", path.display())]
    NoPage {
        /// The path of the output.
        path: PathBuf,
    },
    /// An output file or folder could not be created.
    #[error("cannot create {}", path.display())]
    Create {
        /// The path of the file or folder.
        path: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// An output could not be written during the run.
    #[error("cannot write {}", path.display())]
    Write {
        /// The path of the output.
        path: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// A quantity has no finite value on the way from a start of a section.
    #[error("start {start}, at t = {time}")]
    NoValue {
        /// The number of the start, from 1.
        start: usize,
        /// The time (s).
        time: f64,
        /// The quantity, the part of it without a value, and the state.
        source: Box<FormulaSystemError>,
    },
    /// No integrator has this text in its name.
    #[error("no integrator has `{}` in its name; there are {}", text(only), names.join(", "))]
    NoContestant {
        /// The text that was asked for.
        only: String,
        /// The names of all integrators.
        names: Vec<String>,
    },
    /// The system refuses this number of threads.
    #[error("cannot start {threads} thread(s)")]
    Threads {
        /// The number of threads.
        threads: usize,
        /// The error of the thread pool.
        source: rayon::ThreadPoolBuildError,
    },
    /// The system refuses the threads for parallel work.
    #[error("cannot start threads, of which RAYON_NUM_THREADS sets the number")]
    Workers(#[source] rayon::ThreadPoolBuildError),
    /// The section that the configuration asks for does not exist.
    #[error("[section]")]
    Section(#[from] SectionError),
    /// The section of a system that the configuration asks for does not exist.
    #[error("[section]")]
    SystemSection(#[source] Box<FormulaSystemError>),
    /// No coordinate or angle of a top has the name of the surface.
    #[error("section.surface: {0}")]
    UnknownSurface(String),
    /// The section of a system has no surface.
    #[error("[section] surface is missing: a formula, such as a coordinate")]
    NoSurface,
    /// The zeros of a function of coordinates are looked for along a path with noise.
    #[error(
        "{key}: {function} is a function of coordinates, whose value a path with noise passes again and again in any time, however \
         short: where depends on the step; write a function of t alone, such as sin(2*t)"
    )]
    NoisyFunction {
        /// The key of the function.
        key: String,
        /// The function.
        function: String,
    },
    /// A key of the section is for systems, or for tops.
    #[error("[section] {key} is of the section of {of} alone")]
    SectionKey {
        /// The key of `[section]` that is not allowed here.
        key: &'static str,
        /// The kind of section that has the key.
        of: &'static str,
    },
    /// The limits of the picture of a section are no range.
    #[error("[section] limits.{axis} must be {needs}, got [{}, {}]", number(*from), number(*to))]
    PlaneLimits {
        /// The axis: x or y.
        axis: &'static str,
        /// What the limits must be, in words.
        needs: &'static str,
        /// The lower limit.
        from: f64,
        /// The upper limit.
        to: f64,
    },
    /// A state that is given does not reach the surface.
    #[error("[section] state {state} does not cross the surface within {longest} s")]
    NeverCrosses {
        /// The number of the state, from 1.
        state: usize,
        /// The time for which it was followed, s.
        longest: f64,
    },
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
    /// There is no function whose zeros are to be found.
    #[error("[events] functions is missing: formulas whose zeros are found, such as [\"Gamma3\"]")]
    NoEvents,
    /// A function whose zeros are to be found is no formula.
    #[error("[events] functions[{number}]")]
    EventFunction {
        /// The number of the function, from 0.
        number: usize,
        /// What is wrong with it.
        source: Box<FormulaError>,
    },
    /// The sweep that the configuration asks for does not exist.
    #[error("[sweep]")]
    Sweep(#[from] SweepError),
    /// The Lie–Poisson system that the configuration asks for does not exist.
    #[error("{}", .0.table())]
    System(#[source] Box<SystemTableError>),
    /// No member of a sweep could be followed.
    #[error("all {members} {nouns} failed; the first: {first}")]
    AllFailed {
        /// The number of members.
        members: u64,
        /// The word for several members.
        nouns: &'static str,
        /// The reason why the first member could not be followed.
        first: String,
    },
    /// The tangent vectors of a member of a sweep have lost their directions.
    #[error(transparent)]
    Tangent(VariationalError),
    /// An interrupted run has left a checkpoint or tiles.
    #[error(
        "{} is of an interrupted run: go on with {resume}, or discard it with --restart", path.display()
    )]
    Unfinished {
        /// The path of its checkpoint, or of the folder of its tiles.
        path: PathBuf,
        /// The argument that resumes it.
        resume: String,
    },
    /// A finished tile of an interrupted run cannot be read.
    #[error("cannot read {}", path.display())]
    Tile {
        /// The path of the tile.
        path: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// A tile is missing that should have been finished.
    #[error(
        "tile {tile} is missing in {}, which must be on a file system that all processes see",
        folder.display()
    )]
    MissingTile {
        /// The number of the tile.
        tile: u64,
        /// The folder of the tiles.
        folder: PathBuf,
    },
    /// Two reference solutions differ too much.
    #[error(
        "the reference solution is certain to {uncertainty:.1e} of its size only, not to {most:e}: \
         lower [integrator] step, or the end"
    )]
    Reference {
        /// The distance of the two solutions, relative to their size.
        uncertainty: f64,
        /// The largest distance allowed.
        most: f64,
    },
    /// A figure could not be drawn.
    #[error("cannot draw the figure: {0}")]
    Figure(String),
    /// The run was stopped.
    #[error("interrupted{}", .resume.as_deref().map_or_else(String::new, resumption))]
    Interrupted {
        /// The argument that resumes the run, if it can be resumed.
        resume: Option<String>,
    },
    /// A run failed because of something outside it, and can be resumed.
    #[error("the run can go on by the same command with {resume}")]
    Resumable {
        /// The argument that resumes the run.
        resume: String,
        /// The error that made the run fail.
        source: Box<Error>,
    },
    /// A run failed, and what it had computed was kept.
    #[error("what was computed until the run failed is in {}", partial.display())]
    Kept {
        /// The path of the partial output.
        partial: PathBuf,
        /// The error that made the run fail.
        source: Box<Error>,
    },
}

impl Error {
    /// Turns an error about creating a file into one about writing it, when it is too late to refuse the request.
    pub(crate) fn too_late(self) -> Self {
        match self {
            Self::Create { path, source } => Self::Write { path, source },
            other => other,
        }
    }
}

/// Returns the name of a number without the table of the configuration that has it.
fn without_table(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or(name)
}

/// Returns the end of a message, which names the argument that resumes the run.
pub(super) fn resumption(argument: &str) -> String {
    format!("; go on by the same command with {argument}")
}
