//! Poincaré sections of systems: level sets of the conserved quantities, and the states on a surface in them.

pub(crate) mod level_set;
pub(crate) mod orbit;
pub(crate) mod start_search;
mod orbit_states;
pub(crate) mod system_section;
