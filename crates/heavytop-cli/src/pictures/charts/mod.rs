//! Charts that plotters draws: axes with their ticks, sheets with captions, and frames with bars of colours.

pub(crate) mod axis;
pub(crate) mod scale;
pub(crate) mod sheet;
pub(crate) mod scaled_chart;
pub(crate) mod frame;
