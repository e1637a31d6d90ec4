//! The common parts of all pictures: axes, colours, captions, curves, text as outlines, PNG and films.

pub(crate) mod numerals;
pub(crate) mod symbols;
pub(crate) mod lettering;
pub(crate) mod colour_scale;
pub(crate) mod caption;
pub(crate) mod raster;
pub(crate) mod render;
pub(crate) mod charts;
pub(crate) mod curves;
pub(crate) mod films;

pub(crate) use charts::axis::Axis;
pub(crate) use charts::frame::Frame;
pub(crate) use charts::scale::Scale;
