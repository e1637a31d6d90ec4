//! A run of any Lie–Poisson system, whose Hamiltonian is a formula.

mod system_experiment;

pub use system_experiment::{SystemExperiment, SystemMoment};
