//! The promises of the crate: tops, kernels, splittings and closed forms.
#![allow(clippy::unwrap_used, clippy::panic)]

mod integrable;
mod kernels;
mod laws;
mod motions;
mod parameters;
