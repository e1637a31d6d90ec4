//! The integrators of systems by name: a formulation, a scheme, and a task to perform with the integrator.

pub(crate) mod system_task;
pub(crate) mod offers;
pub(crate) mod clebsch_maps;
pub(crate) mod invariant_guard;
pub(crate) mod integration;
pub(crate) mod system_method;
mod spectral_radius;
mod system_accuracy;
