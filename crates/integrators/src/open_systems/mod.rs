//! Motions on coadjoint orbits whose field depends on time, with the time as a coordinate of the state.

pub(crate) mod driven_field;
pub(crate) mod driven;
