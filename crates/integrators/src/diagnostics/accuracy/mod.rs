//! How accurate a run is: its error, estimated from a repetition with half the step, and how far a step turns.

mod system_scales;
mod relative_distance;
mod sampled_run;
mod error_growth;
mod run_accuracy;
mod step_check;

pub use run_accuracy::{RunAccuracy, run_accuracy};
pub use step_check::{StepCheck, check_by_half_steps};
pub use system_scales::SystemScales;
