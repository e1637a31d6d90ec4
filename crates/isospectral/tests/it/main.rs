//! What this crate promises.
#![allow(clippy::unwrap_used)]

mod algebra;
mod examples;
mod failures;
mod matrices;
mod methods;
mod poisson;
