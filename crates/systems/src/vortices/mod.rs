//! Vortices on the sphere.

pub(crate) mod point_vortices;
