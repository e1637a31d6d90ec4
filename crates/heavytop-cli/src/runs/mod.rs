//! A run of a top or of another Lie–Poisson system, as the crate [`lie_poisson_runs`] has it, and its accuracy in words.

pub(crate) mod run_check;
pub(crate) mod top_columns;

pub use lie_poisson_runs::{Experiment, Model, Moment, Pace, Saved, Schedule, TopInAxes};
pub use run_check::{RunCheck, WithoutOrder};
