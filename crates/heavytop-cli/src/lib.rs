//! The library of the program `heavytop`, which simulates heavy tops, compares integrators, and writes tables, figures,
//! Poincaré sections and chaos maps.
//!
//! The mathematics is in the crate [`heavytop`]. This crate adds configurations, output files, pictures and progress
//! bars. To install the program:
//!
//! ```sh
//! cargo install --path crates/heavytop-cli
//! ```
//!
//! Each command of the program is a function. This one follows the paper's top for 100 s, and writes a file that NumPy
//! reads:
//!
//! ```
//! use heavytop_cli::commands::simulate::{SimulateOptions, simulate};
//! use heavytop_cli::configuration::Config;
//! let folder = tempfile::tempdir()?;
//! let out = folder.path().join("kovalevskaya.npz");
//! let summary = simulate(&Config::default(), &out, &SimulateOptions::default())?;
//! assert_eq!((summary.steps, summary.end), (5000, 100.0));
//! assert!(out.exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which module when
//!
//! | when you need | use |
//! |---|---|
//! | a command: `simulate`, `reproduce`, `compare`, `section`, `sweep`, `animate`, `bench` | [`commands`] |
//! | a configuration by name, and its tables | [`configuration`] |
//! | the samples of a run one by one | [`runs`] |
//! | formulations and schemes by name, the integrator of both | [`heavytop::methods`] |
//! | to stop a command, or to hide or show its progress | [`supervision`] |
//! | the reason why a command failed, its text and its exit code | [`Error`], [`errors`] |
//! | the whole program in one call | [`main`] |
//!
//! The other modules serve the commands: `reading` for configurations from files and assignments, `formats` for the
//! columns of a run and CSV, npz and Parquet, `files` for outputs that appear under their names only when they are complete,
//! `pictures` for axes, captions, colours and the rendering of SVG, and `interface` for the command line with its help,
//! signals and standard output.
//!
//! # Conventions
//!
//! All numbers are in SI units. Π and Γ are in the body frame. Symbols, signs and sides are those of the crate
//! [`heavytop`].
//!
//! The names of commands, keys, columns and files, and the exit codes, are a contract with the scripts that call the
//! program. The items of this library are not.
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! With the feature `mpi` the processes of an MPI job share the work of `sweep`. It needs an MPI library, such as Open
//! MPI, and libclang. The oldest supported compiler is Rust 1.89.
//!
//! # Related crates
//!
//! [`heavytop`] holds the tops and the formulations and schemes by name, `lie-poisson-formula-systems` the systems by
//! formula, [`lie_poisson_runs`] the runs of both, and `collective-integrators` the integrators, ensembles and indicators
//! of chaos. `heavytop-python` offers the same computations to Python, and `heavytop-page` in a browser.

mod vocabulary;
pub mod errors;
#[doc(hidden)]
pub mod files;
mod fields;
pub mod runs;
pub mod configuration;
#[doc(hidden)]
pub mod reading;
#[doc(hidden)]
pub mod formats;
mod pictures;
pub mod supervision;
pub mod commands;
mod interface;

pub use errors::Error;
pub use interface::main;
