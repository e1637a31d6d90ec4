//! The command `heavytop events`, which finds where functions of the state are zero along a run.

mod events_summary;
mod events_command;

pub use events_command::events;
pub use events_summary::EventsSummary;
