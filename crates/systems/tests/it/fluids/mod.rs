//! Zeitlin's model of fluids on the sphere, and what acts on them from outside.

mod fluid_on_sphere;
mod stochastic_fluid;
mod viscous_fluid;
pub mod zeitlin;
mod zeitlin_coordinates;
