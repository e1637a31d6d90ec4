//! The common parts of all pictures: axes, colours, captions, curves, text as outlines, PNG and films.

pub(crate) mod numerals;
pub(crate) mod lettering;
mod axis;
mod scale;
pub(crate) mod colour_scale;
pub(crate) mod caption;
pub(crate) mod frame;
pub(crate) mod raster;
pub(crate) mod render;
pub(crate) mod curves;
pub(crate) mod films;

pub(crate) use axis::Axis;
pub(crate) use frame::Frame;
pub(crate) use scale::Scale;
