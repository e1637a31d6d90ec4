//! Drawings that the library plotters composes.

pub(crate) mod paints;
pub(crate) mod svg_canvas;
pub(crate) mod svg_element;
