//! How accurate a run is: its error, estimated from a repetition with half the step, and how far a step turns.

mod system_scales;
mod relative_distance;
mod sampled_run;
mod error_growth;
mod sensitivity;
mod reported_accuracy;
mod run_accuracy;
mod step_check;

pub use reported_accuracy::RunAccuracy;
pub use run_accuracy::run_accuracy;
pub use step_check::{NoOrder, StepCheck, check_by_half_steps};
pub use system_scales::SystemScales;
