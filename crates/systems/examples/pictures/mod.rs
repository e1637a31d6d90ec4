//! What the examples share: arguments, and pictures with axes, colours and keys, as PNG or SVG.

#![allow(dead_code, reason = "each example uses a part of this module")]

pub mod arguments;
pub mod canvas;
pub mod colours;
pub mod curves;
pub mod mollweide;
pub mod raster;
