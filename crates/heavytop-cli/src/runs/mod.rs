//! A run of a top: its steps, its integrator, and its samples one by one.

mod schedule;
pub(crate) mod step_angle;
pub(crate) mod method_warning;
mod moment;
mod experiment;

pub use experiment::Experiment;
pub use moment::{Moment, Saved};
pub use schedule::Schedule;
