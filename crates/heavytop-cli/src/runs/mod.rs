//! A run of a top or of another Lie–Poisson system, as the crate [`lie_poisson_runs`] has it, and its accuracy in words.

pub(crate) mod run_check;

pub use lie_poisson_runs::{
    Described, Experiment, Moment, Pace, Run, Saved, Schedule, SystemExperiment,
};
pub use run_check::{RunCheck, WithoutOrder};
