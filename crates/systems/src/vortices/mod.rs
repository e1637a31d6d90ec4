//! Vortices on the sphere.

pub(crate) mod interaction;
pub(crate) mod lane_interaction;
pub(crate) mod many_vortices;
pub(crate) mod point_vortices;
pub(crate) mod sources;
