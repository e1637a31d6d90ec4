//! Chains and lattices of spins.

mod driven_lattices;
mod heisenberg_lattice;
mod lattice_on_lanes;
pub mod spin_chain;
mod spin_lattice;
mod thermal_spins;
