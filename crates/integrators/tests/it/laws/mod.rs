//! The law suites of the crate, and types that break one law each.

mod faulty_integrators;
mod faulty_schemes;
pub mod integrator_laws;
mod pinned_integrators;
