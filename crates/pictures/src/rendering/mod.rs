//! Drawings as SVG without text, and as PNG.

pub(crate) mod pixels;
pub(crate) mod cells;
pub(crate) mod picture;
