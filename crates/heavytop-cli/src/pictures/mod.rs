//! The common parts of all pictures: axes, colours, text as outlines, and PNG.

mod axis;
pub(crate) mod colour_scale;
pub(crate) mod render;

pub(crate) use axis::Axis;
