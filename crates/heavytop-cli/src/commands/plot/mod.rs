//! The command `heavytop plot`, which draws the arrays of a run.

mod plot_command;
mod chain_picture;
mod lattice_picture;
mod sphere_picture;
mod run_arrays;

pub use plot_command::{PlotSummary, plot};
