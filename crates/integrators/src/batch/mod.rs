//! Many trajectories at once: in SIMD lanes, on threads.

pub(crate) mod batch_integrator;
pub(crate) mod laned;
pub(crate) mod ensemble;
