//! The promises of the crate: schemes, integrators and indicators of chaos.
#![allow(clippy::unwrap_used, clippy::panic)]

mod chaos;
mod laws;
mod schemes;
mod sites;
mod steps;
mod support;
