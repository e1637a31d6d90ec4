//! Many trajectories at once: in SIMD lanes and on all threads.

pub(crate) mod batch_integrator;
pub(crate) mod group_engine;
pub(crate) mod lane_kernel;
pub(crate) mod laned;
pub(crate) mod ensemble;
