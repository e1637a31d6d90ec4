//! What a physicist wants to know of the motion of a top: rates, turning points, steady rotations, and textbook formulas.

pub(crate) mod report_line;
pub(crate) mod steady_rotation;
pub(crate) mod top_report;
mod axis_frame;
mod measured_motion;
mod report_text;
mod textbook;
