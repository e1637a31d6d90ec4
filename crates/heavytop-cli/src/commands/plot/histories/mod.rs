//! Pictures of a whole run against time, and of its columns against one another.

mod thinned;
mod time_axis;
mod panel_plan;
mod plan_curves;
mod deviation_curves;
pub(super) mod chain_picture;
pub(super) mod panels_picture;
pub(super) mod phase_portrait;
