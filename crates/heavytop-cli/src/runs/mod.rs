//! A run of a top: its steps, its integrator, and its samples one by one.

mod schedule;
pub(crate) mod step_angle;
mod task;
mod method;
mod moment;
mod experiment;

pub use experiment::Experiment;
pub use method::Method;
pub use moment::{Moment, Saved};
pub use schedule::Schedule;
pub use task::{TangentTask, Task};
