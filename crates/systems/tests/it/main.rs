//! The promises of the crate: the equations of the literature, and what a collective Gauss method conserves.
#![allow(clippy::unwrap_used, clippy::panic)]

mod all_systems;
mod bodies;
mod fluids;
mod law_samples;
mod laws;
mod open_fluids;
mod satellite;
mod spins;
mod vortices;
