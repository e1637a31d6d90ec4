//! What this crate promises.

mod examples;
mod failures;
mod matrices;
mod methods;
mod poisson;
