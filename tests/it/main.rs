//! The checks that need two crates: the statements of the paper, and the promises of the documentation.
#![allow(clippy::unwrap_used, clippy::panic)]

mod analysis;
mod bits;
mod documents;
mod groups;
mod integrators;
mod other_systems;
mod realisation;
mod round_off;

/// The tutorial `docs/write_your_own.rs`, which runs as a test.
#[path = "../../docs/write_your_own.rs"]
mod write_your_own;
