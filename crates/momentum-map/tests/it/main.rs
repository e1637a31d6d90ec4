//! The promises of the crate: actions, Poisson maps and their lifts.
#![allow(clippy::unwrap_used, clippy::panic)]

mod attached_fibres;
mod clebsch_maps;
mod closed_generators;
mod extreme_lifts;
mod map_faults_of_any_size;
mod map_laws;
mod multipliers;
mod phase_space_laws;
mod required_items;
mod support;
mod units_of_multipliers;
