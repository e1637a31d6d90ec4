//! Systems of arrays with friction, forces and noise.

pub(crate) mod noise_paths;
pub(crate) mod lattice_field;
pub(crate) mod array_terms;
pub(crate) mod open_arrays;
pub(super) mod opened;
pub(super) mod opened_lattice;
pub(super) mod opened_fluid;
mod on_path;
