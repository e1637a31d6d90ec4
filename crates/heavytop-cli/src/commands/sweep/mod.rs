//! The command `heavytop sweep`, which follows many tops, or motions of another system, at once and maps their observables.

mod families;
mod sweep_plan;
mod measured_row;
mod member_tiles;
mod member_table;
mod member_csv;
mod pictures;
mod processes;
mod judgements;
mod sweep_summary;
mod sweep_forecast;
mod sweep_command;

pub use sweep_command::{sweep, sweep_if};
pub use sweep_forecast::dry_run;
pub use sweep_summary::SweepSummary;
