//! The command `heavytop bench`, which measures the computing times and errors of the integrators.

mod problem_file;
mod bench_command;

pub use bench_command::{Bench, BenchOptions, bench};
