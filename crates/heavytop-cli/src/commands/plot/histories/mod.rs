//! Pictures of a whole run against time, and of its columns against one another.

mod thinned;
mod time_axis;
pub(super) mod panel_plan;
pub(super) mod plan_curves;
mod deviation_curves;
pub(super) mod chain_picture;
pub(super) mod panels_picture;
pub(super) mod phase_portrait;
