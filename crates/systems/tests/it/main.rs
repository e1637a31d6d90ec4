//! The promises of the crate: the equations of the literature, and what a collective Gauss method conserves.
#![allow(clippy::unwrap_used, clippy::panic)]

mod beyond_switches;
mod drifts;
mod fluid_on_sphere;
mod generalised_rigid_body;
mod gyrostat;
mod kida_vortex;
mod heap_states;
mod heisenberg_lattice;
mod hessians;
mod kirchhoff;
mod lattice_on_lanes;
mod laws;
mod many_vortices;
mod movable_base;
mod point_vortices;
mod spin_chain;
mod spin_lattice;
mod vortex_table;
mod vortices_on_lanes;
mod zeitlin;
