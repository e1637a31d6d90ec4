//! The rotation of the body in a step, and trajectories with the attitude.

pub(crate) mod euler_angles;
pub(crate) mod step_rotation;
pub(crate) mod with_attitude;
