//! Integrators on 𝔤∗, and their trajectories: from a state, and from a momentum.

pub(crate) mod sample;
pub(crate) mod integrator;
pub(crate) mod start;
