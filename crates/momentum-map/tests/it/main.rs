//! The promises of the crate: actions, Poisson maps and their lifts.
#![allow(clippy::unwrap_used, clippy::panic)]

mod attached_fibres;
mod clebsch_maps;
mod closed_generators;
mod extreme_lifts;
mod laws;
mod required_items;
mod support;
