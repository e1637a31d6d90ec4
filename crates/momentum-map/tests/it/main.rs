//! What actions, Poisson maps and their lifts promise.
#![allow(clippy::unwrap_used, clippy::panic)]

mod extreme_lifts;
mod map_laws;
mod multipliers;
mod support;
