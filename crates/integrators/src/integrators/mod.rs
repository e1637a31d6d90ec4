//! Integrators on 𝔤∗, with their states, their momenta and their trajectories.

pub(crate) mod trajectories;
pub(crate) mod state_is_momentum;
pub(crate) mod compensated;
pub(crate) mod recentring_threshold;
pub(crate) mod finite_momentum;
pub(crate) mod collective;
pub(crate) mod direct;
pub(crate) mod multiplier_field;
pub(crate) mod lift_free;
pub(crate) mod lanes;
pub(crate) mod sites;
