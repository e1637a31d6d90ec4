//! A run: its steps, its integrator, and its samples one by one.

pub(crate) mod schedule;
mod strides;
pub(crate) mod pace;
pub(crate) mod path_ensemble;
pub(crate) mod moment;
pub(crate) mod experiment;
mod balances;
pub(crate) mod events;
pub(crate) mod tangent_growth;
