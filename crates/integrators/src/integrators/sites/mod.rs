//! Integrators for N points, with N known when the program runs: collective ones for N copies of a realisation, and the
//! spherical midpoint method.

pub(crate) mod collective_sites;
pub(crate) mod lift_free_sites;
pub(crate) mod spherical_midpoint;
