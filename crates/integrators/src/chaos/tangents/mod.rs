//! States that carry tangent vectors along.

mod orthonormal_frame;
pub(crate) mod tangent_scales;
mod tangent_steps;
mod carrier;
pub(crate) mod variational_flow;
pub(crate) mod tangent_frame;
