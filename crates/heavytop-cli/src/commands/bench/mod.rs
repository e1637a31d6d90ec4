//! `heavytop bench`: how long the integrators take, and how right they are.

mod problem;
mod clock;
mod contestants;
mod bench_command;

pub use bench_command::{Bench, BenchOptions, bench};
pub use clock::Run;
pub use problem::Problem;
