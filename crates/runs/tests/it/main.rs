//! Tests of runs, of their errors, and of the timing of integrators.
#![allow(clippy::unwrap_used)]

mod arrays;
mod balances_of_runs;
#[cfg(feature = "contests")]
mod contests;
#[cfg(feature = "contests")]
mod errors_of_runs;
mod statistics_of_paths;
mod rows_of_runs;
mod support;
mod tangents_of_long_steps;
mod tops;
