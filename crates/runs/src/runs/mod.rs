//! A run of a top or of another Lie–Poisson system: its steps, its integrator, and its samples one by one.

pub(crate) mod schedule;
pub(crate) mod pace;
pub mod step_angle;
pub mod method_warning;
pub(crate) mod moment;
pub(crate) mod run;
pub(crate) mod experiment;
pub(crate) mod system_experiment;
pub(crate) mod tangent_growth;
