//! A run of any Lie–Poisson system, whose Hamiltonian is a formula.

mod system_algebra;
mod system_integrator;
mod system_experiment;

pub use system_algebra::{SystemAlgebra, WIDEST};
pub use system_experiment::{SystemExperiment, SystemMoment};
