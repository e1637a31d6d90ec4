//! The program `heavytop`: configuration, output files, figures and progress bars around the
//! crate [`heavytop`], which has the mathematics.
//!
//! The modules in dependency order:
//!
//! | object | module |
//! |---|---|
//! | what can go wrong, and the exit codes | [`error`] |
//! | formulations and schemes by name, and which go together | [`method`] |
//! | the integrator of a formulation and a scheme | [`integrators`] |
//! | the number of steps of a run | [`schedule`] |
//! | the configuration | [`config`] |
//! | tops by name | [`preset`] |
//! | configurations from text and as text | `reading` |
//! | what a misspelt name may have meant | `suggestion` |
//! | numbers and texts in messages | `brief` |
//! | files that may have no end | `bounded` |
//! | one writer for each file | `lock` |
//! | a run, sample by sample | [`run`] |
//! | files that appear when they are complete | [`output`] |
//! | rows of numbers | [`table`] |
//! | ranges, ticks and tick labels | `axis` |
//! | CSV, NumPy's npz, Parquet | [`formats`] |
//! | what an interrupted run leaves, and whether it is whole | `sealed` |
//! | finished parts of a run | [`tiles`] |
//! | text to outlines, and SVG to PNG | `render` |
//! | the progress bar | [`progress`] |
//! | who may stop a command | [`watch`] |
//! | `heavytop simulate` | [`simulate`] |
//! | `heavytop reproduce` | [`reproduce`] |
//! | `heavytop compare` | [`compare`] |
//! | `heavytop section` | [`section`] |
//! | `heavytop animate` | [`animate`] |
//! | `heavytop bench` | [`mod@bench`] |
//! | `heavytop sweep` | [`sweep`] |
//! | what `--help` says | `help` |
//! | the command line | [`cli`] |
//!
//! The names of commands, keys, columns and files and the exit codes are a contract with the
//! scripts that call the program; this library's items are not.

pub mod error;
pub mod method;
pub mod integrators;
pub mod schedule;
pub mod config;
pub mod preset;
mod reading;
mod suggestion;
mod brief;
mod bounded;
mod lock;
pub mod run;
pub mod output;
pub mod table;
mod axis;
pub mod formats;
mod sealed;
pub mod tiles;
mod render;
pub mod progress;
pub mod watch;
pub mod simulate;
pub mod reproduce;
pub mod compare;
pub mod section;
pub mod animate;
pub mod bench;
pub mod sweep;
mod help;
pub mod cli;

pub use cli::main;
pub use error::Error;
