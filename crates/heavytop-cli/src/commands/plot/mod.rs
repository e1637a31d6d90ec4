//! The command `heavytop plot`, which draws a run.

mod view;
mod run_subject;
mod run_arrays;
mod picture_format;
mod plot_options;
mod plot_summary;
mod quantities;
mod histories;
mod samples;
mod terminal;
mod whole_run;
mod whole_text;
mod plot_command;

pub use plot_command::{plot, plot_as_text};
pub use plot_options::PlotOptions;
pub use plot_summary::PlotSummary;
