//! Collective integrators for N copies of a realisation, with N known when the program runs.

pub(crate) mod collective_sites;
pub(crate) mod lift_free_sites;
