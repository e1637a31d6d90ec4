//! Pictures of a whole run against time.

mod thinned;
mod top_words;
mod time_axis;
mod panel_plan;
mod deviation_curves;
pub(super) mod chain_picture;
pub(super) mod panels_picture;
