//! A run of a top or of another Lie–Poisson system: its steps, its integrator, and its samples one by one.

pub(crate) mod schedule;
mod pace;
pub(crate) mod step_angle;
pub(crate) mod run_check;
pub(crate) mod method_warning;
mod moment;
mod run;
mod experiment;
mod system_experiment;

pub use experiment::Experiment;
pub use moment::{Moment, Saved};
pub use pace::Pace;
pub use run::{Described, Run};
pub use run_check::{RunCheck, WithoutOrder};
pub use schedule::Schedule;
pub use system_experiment::SystemExperiment;
