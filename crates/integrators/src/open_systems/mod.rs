//! Motions that are driven, damped, noisy or forced, with the time as a coordinate of the state.

pub(crate) mod smooth_pieces;
pub(crate) mod step_parts;
pub(crate) mod paths;
pub(crate) mod noise_rule;
pub(crate) mod affine_flow;
pub(crate) mod driven_field;
pub(crate) mod driven;
pub(crate) mod noisy;
pub(crate) mod noisy_reduced;
pub(crate) mod torqued;
pub(crate) mod torques;
