//! Integrators for many copies of one space.

pub mod collective_sites;
mod lift_free_sites;
mod spherical_midpoint;
