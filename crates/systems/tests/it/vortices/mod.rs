//! Vortices on the sphere and in the plane.

mod kida_vortex;
mod many_vortices;
mod point_vortices;
mod vortex_table;
mod vortices_on_lanes;
