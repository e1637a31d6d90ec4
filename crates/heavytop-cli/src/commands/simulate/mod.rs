//! The command `heavytop simulate`, which follows one top, or another system, and writes one file.

mod checkpoints;
mod simulate_options;
mod recording;
mod run_balance;
mod run_summary;
mod run_forecast;
mod renewal;
mod simulate_command;

pub use checkpoints::checkpoint::Checkpoint;
pub use run_balance::{RunBalance, Supply};
pub use run_forecast::{dry_run, forecast};
pub use run_summary::RunSummary;
pub use simulate_command::simulate;
pub use simulate_options::{Measures, SimulateOptions};
