//! A run of a top or of another Lie–Poisson system: its steps, its integrator, and its samples one by one.

pub(crate) mod schedule;
mod pace;
pub(crate) mod step_angle;
pub(crate) mod method_warning;
pub(crate) mod run_check;
mod moment;
mod visited_samples;
mod experiment;
mod systems;

pub use experiment::Experiment;
pub use moment::{Moment, Saved};
pub use pace::Pace;
pub use run_check::{RunCheck, WithoutOrder};
pub use schedule::Schedule;
pub use systems::{SystemExperiment, SystemMoment};
