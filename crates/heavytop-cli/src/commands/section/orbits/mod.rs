//! The orbits of the starts of a section, on their way through the tiles, and their accuracy.

pub(super) mod orbit;
pub(super) mod orbit_tiles;
pub(super) mod orbit_accuracy;
