//! What this crate promises.
#![allow(clippy::unwrap_used)]

mod algebra;
mod blocks_of_matrices;
mod examples;
mod isospectral_failures;
mod matrices;
mod isospectral_methods;
mod open_systems;
mod poisson;
