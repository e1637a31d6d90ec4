//! The promises of the crate: schemes, integrators, events and indicators of chaos.
#![allow(clippy::unwrap_used, clippy::panic)]

mod chaos;
mod driven;
mod torques;
mod laws;
mod noisy;
mod runs;
mod schemes;
mod sites;
mod steps;
mod support;
