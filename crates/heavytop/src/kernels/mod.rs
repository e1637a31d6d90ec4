//! Integrators with special formulas for tops.

pub(crate) mod infinitesimal_rotation;
pub(crate) mod midpoint;
pub(crate) mod gauss_one;
pub(crate) mod gauss_many;
pub(crate) mod symmetric;
