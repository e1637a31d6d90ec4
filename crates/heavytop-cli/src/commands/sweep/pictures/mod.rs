//! The pictures of a sweep: heat maps over a grid with two axes, and curves over a single axis.

mod words;
mod colours;
mod map_colours;
mod heat_map;
mod member_curve;
mod sweep_picture;

pub(super) use sweep_picture::SweepPicture;
