//! The program `heavytop`: configuration, output files, figures and progress bars around the
//! crate [`heavytop`], which has the mathematics.
//!
//! The folders in dependency order:
//!
//! | folder | what is in it |
//! |---|---|
//! | [`vocabulary`] | formulations, schemes and other items by name; numbers and texts in messages |
//! | [`errors`] | what can go wrong, and the exit codes |
//! | [`files`] | files that appear when they are complete, and have one writer |
//! | [`runs`] | the steps of a run, its integrator, and its samples one by one |
//! | [`configuration`] | the tables of a configuration, tops by name, configurations from text and as text |
//! | [`formats`] | CSV, NumPy's npz, Parquet |
//! | `pictures` | axes, colours, text to outlines, SVG to PNG |
//! | [`supervision`] | the progress bar, who may stop a command, finished parts of a run |
//! | [`commands`] | `heavytop simulate`, `reproduce`, `compare`, `section`, `animate`, `bench`, `sweep` |
//! | `interface` | the command line, `--help`, signals, standard output, the end of memory |
//!
//! The names of commands, keys, columns and files and the exit codes are a contract with the
//! scripts that call the program; this library's items are not.

pub mod vocabulary;
pub mod errors;
pub mod files;
pub mod runs;
pub mod configuration;
pub mod formats;
mod pictures;
pub mod supervision;
pub mod commands;
mod interface;

pub use errors::Error;
pub use interface::{MemoryGuard, main};
