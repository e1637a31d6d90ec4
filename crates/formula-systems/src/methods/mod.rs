//! The integrators of systems by name: a formulation and a scheme.

pub(crate) mod offers;
pub(crate) mod invariant_guard;
pub(crate) mod table_field;
pub(crate) mod formula_of_sites;
pub(crate) mod integration;
pub(crate) mod in_lanes;
mod integrators;
mod spectral_radius;
mod scales;
