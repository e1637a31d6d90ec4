//! Fluids on the sphere that viscosity damps, forces stir, and noise carries along.

mod balances;
mod driven_fluids;
mod stirring;
mod support;
mod transport_noise;
mod viscous_decay;
