//! Fluids on the sphere.

pub(super) mod fluid_start;
pub(super) mod sphere_fluid;
mod sphere_fluid_arrays;
