//! The summary of `plot`.

use crate::files::place::shown;
use crate::vocabulary::brief::number;
use serde::Serialize;
use std::fmt;
use std::path::PathBuf;

/// The summary of a picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlotSummary {
    /// The path of the picture.
    pub out: PathBuf,
    /// The time of the sample that is drawn last, s.
    pub time: f64,
    /// The number of frames of a film.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frames: Option<usize>,
    /// Whether the picture shows the whole run.
    #[serde(skip)]
    pub(super) is_whole: bool,
}

impl fmt::Display for PlotSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { out, frames, is_whole, .. } = self;
        let time = number(self.time);
        match frames {
            Some(1) => write!(to, "1 frame at t = {time} s in {}", shown(out)),
            Some(frames) => write!(to, "{frames} frames up to t = {time} s in {}", shown(out)),
            None if *is_whole => write!(to, "the run to t = {time} s in {}", shown(out)),
            None => write!(to, "t = {time} s in {}", shown(out)),
        }
    }
}
