//! The summary of a page, which `heavytop animate` prints.

use super::animation::Animation;
use crate::files::place::shown;
use crate::runs::run_check::{write_accuracy, write_method};
use crate::runs::{Experiment, Pace, TopInAxes};
use serde::Serialize;
use std::fmt;
use std::path::{Path, PathBuf};

/// The summary of a page, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PageSummary {
    /// The path of the page.
    pub out: PathBuf,
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The number of steps.
    pub steps: u64,
    /// The time after the last step, s.
    pub end: f64,
    /// The number of frames.
    pub frames: usize,
    /// The number of steps from frame to frame.
    pub steps_per_frame: u64,
    /// The largest angle by which the body turns from frame to frame, rad.
    pub largest_turn: f64,
    /// The estimated error of the run, to two digits: the largest |Δμ_b|/|μ_b| over Π and Γ. 1 means that nothing of the
    /// state is right.
    pub error_estimate: Option<f64>,
}

impl PageSummary {
    /// Creates the summary of a page, as yet without the accuracy of its motion.
    pub(super) fn new(
        experiment: &Experiment<TopInAxes>,
        animation: &Animation,
        out: &Path,
    ) -> Self {
        let Experiment { method, pace: Pace { schedule, every }, .. } = experiment;
        Self {
            out: out.into(),
            formulation: method.formulation().name(),
            scheme: method.scheme().name(),
            step: schedule.step,
            steps: schedule.steps,
            end: schedule.end(),
            frames: animation.len(),
            steps_per_frame: *every,
            largest_turn: animation.largest_turn(),
            error_estimate: None,
        }
    }
}

impl fmt::Display for PageSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{} frames to t = {} s, in {}", self.frames, self.end, shown(&self.out))?;
        write_accuracy(to, (self.error_estimate, "the state"), None)?;
        write_method(to, (self.formulation, self.scheme), (self.step, self.end))
    }
}
