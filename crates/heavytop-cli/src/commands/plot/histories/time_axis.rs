//! The time of a run along an axis, from the left to the right: [`TimeAxis`].

use crate::pictures::{Axis, Scale};

/// The time of a run, from its start on the left to its end on the right, also backward in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TimeAxis {
    end: f64,
}

impl TimeAxis {
    /// Creates the axis of a run with samples at these times.
    pub fn new(times: &[f64]) -> Self {
        Self { end: times.last().copied().unwrap_or(0.0) }
    }

    /// Returns the scale of an axis of this length, a multiple of the size of the text.
    pub fn scale(&self, length: f64) -> Scale {
        let axis = Axis::along_line(0.0_f64.min(self.end), 0.0_f64.max(self.end), 5, length);
        Scale::linear(&axis, "t (s)", self.end < 0.0)
    }

    /// Returns points (t, value) as places, from 0 to 1 along both axes.
    pub fn places(&self, points: Vec<(f64, f64)>, along: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        let length = if self.end == 0.0 { 1.0 } else { self.end };
        points.into_iter().map(|(time, value)| (time / length, along(value))).collect()
    }
}
