//! The promises of the program `heavytop`, as a user runs it.
#![allow(clippy::unwrap_used, clippy::panic)]

mod animate;
mod assignments;
mod bench;
mod checkpoint;
mod closing;
mod compare;
mod completions;
mod faults;
mod forecasts;
mod formats;
mod init_and_man;
mod initial;
mod interruptions;
mod locks;
mod methods;
#[cfg(feature = "mpi")]
mod mpi;
mod presets;
mod program;
mod progress;
mod quotations;
mod refusals;
mod reproduce;
mod same_bytes;
mod section;
mod simulate;
mod service;
mod sweep;
mod system_sections;
mod system_sweeps;
mod systems;
mod tiles;
mod variants_of_errors;
mod writing;
