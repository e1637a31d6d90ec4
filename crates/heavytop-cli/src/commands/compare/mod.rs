//! The command `heavytop compare`, which measures work against precision for every formulation and scheme.

mod measurement;
mod logarithmic_axes;
mod ranking;
mod curve_labels;
mod chart;
mod recommendations;
mod compare_command;

pub use compare_command::compare;
pub use recommendations::{Choice, Comparison, Recommendation};
