//! The heat maps of a sweep over a grid with two axes.

mod colours;
mod heat_map;

pub(super) use heat_map::{heat_map, size};
