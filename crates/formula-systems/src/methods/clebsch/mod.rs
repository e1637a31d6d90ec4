//! Collective integrators by Clebsch maps: the maps, and a guard of what their steps must conserve.

pub(crate) mod clebsch_maps;
pub(crate) mod invariant_guard;
