//! Systems by formula that are driven, damped, noisy or forced.

pub(crate) mod named_inputs;
pub(crate) mod open_names;
mod spin_terms;
mod elements;
pub(crate) mod open_terms;
pub(crate) mod open_system;
pub(crate) mod open_field;
pub(crate) mod open_integrator;
mod open_methods;
mod open_scales;
