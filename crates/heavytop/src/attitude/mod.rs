//! The rotation that a step makes, and trajectories with the attitude.

pub(crate) mod step_rotation;
pub(crate) mod with_attitude;
