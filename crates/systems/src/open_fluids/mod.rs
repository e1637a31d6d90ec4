//! Fluids on the sphere that viscosity damps, forces stir, and noise carries along.

pub(crate) mod harmonic_bands;
pub(crate) mod viscous_forcing;
pub(crate) mod fluid_budgets;
pub(crate) mod harmonic_noise;
pub(crate) mod stochastic_fluid;
