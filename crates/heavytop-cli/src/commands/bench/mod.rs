//! The command `heavytop bench`, which measures the computing times and errors of the integrators.

mod problem;
mod clock;
mod contestants;
mod bench_command;

pub use bench_command::{Bench, BenchOptions, bench};
pub use clock::Run;
pub use problem::BenchProblem;
