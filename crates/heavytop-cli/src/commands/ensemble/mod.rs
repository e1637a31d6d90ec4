//! The command `heavytop ensemble`, which follows many paths of a motion with noise.

mod ensemble_command;
mod ensemble_summary;

pub use ensemble_command::ensemble;
pub use ensemble_summary::EnsembleSummary;
