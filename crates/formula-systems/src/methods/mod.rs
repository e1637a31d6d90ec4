//! The integrators of systems by name: a formulation and a scheme.

pub(crate) mod offers;
pub(crate) mod clebsch_maps;
pub(crate) mod invariant_guard;
pub(crate) mod integration;
mod integrators;
mod spectral_radius;
mod scales;
