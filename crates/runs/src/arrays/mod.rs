//! Systems of any size whose states are arrays: lattices of spins, vortices, fluids.

pub(crate) mod arguments;
pub(crate) mod array_kind;
pub(crate) mod array_system;
mod any_arrays;
mod directions;
mod renewed;
mod sites;
mod chains;
mod fluids;
mod systems;
pub(crate) mod open;
