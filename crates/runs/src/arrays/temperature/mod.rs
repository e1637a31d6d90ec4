//! Lattices of spins with friction, and at a temperature.

pub(crate) mod lattice_terms;
pub(crate) mod thermal_lattice;
mod lattice_paths;
mod lattice_quantities;
