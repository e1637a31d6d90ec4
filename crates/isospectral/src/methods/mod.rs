//! Integrators of isospectral equations.

pub(crate) mod isospectral_runge_kutta;
pub(crate) mod noisy_isospectral;
pub(crate) mod conjugation;
pub(crate) mod generator_sweeps;
pub(crate) mod generator_history;
pub(crate) mod exponential_midpoint;
pub(crate) mod gauss_magnus;
