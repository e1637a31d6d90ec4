//! Pictures of a sample, and films of several.

pub(super) mod sample_picture;
mod sphere_map;
pub(super) mod direction_track;
mod lattice_plane;
mod fluid_map;
mod vortex_tracks;
mod vortex_map;
pub(super) mod choice;
pub(super) mod film_of_samples;
