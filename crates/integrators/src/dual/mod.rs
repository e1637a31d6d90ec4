//! Integrators on 𝔤∗: what is advanced, and how μ is read off it.

pub(crate) mod integrator;
pub(crate) mod compensated;
pub(crate) mod collective;
pub(crate) mod direct;
pub(crate) mod multiplier_field;
pub(crate) mod lift_free;
pub(crate) mod spherical_midpoint;
