//! The command `heavytop export`, which turns the arrays of a run into the files of other programs.

mod export_command;
mod export_summary;

pub use export_command::{ExportFormat, export};
pub use export_summary::ExportSummary;
