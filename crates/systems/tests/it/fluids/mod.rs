//! Zeitlin's model of fluids on the sphere.

mod fluid_on_sphere;
pub mod zeitlin;
mod zeitlin_coordinates;
