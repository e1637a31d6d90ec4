//! The pace of a run: its steps, and those of which a sample is written.

use super::schedule::Schedule;

/// The steps of a run, and the number n such that every n-th step is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// The steps of the run.
    pub schedule: Schedule,
    /// The number n such that every n-th step is written, and the last one.
    pub every: u64,
}

impl Pace {
    /// Returns the number of samples written up to a step before the last, the initial one included.
    #[must_use]
    pub fn kept(&self, step: u64) -> u64 {
        step / self.every.max(1) + 1
    }

    /// Returns the number of samples that are written, the initial and the last one included.
    #[must_use]
    pub fn rows(&self) -> u64 {
        let last = u64::from(!self.schedule.steps.is_multiple_of(self.every));
        self.kept(self.schedule.steps) + last
    }

    /// Returns whether the sample after this step is written.
    #[must_use]
    pub fn keeps(&self, step: u64) -> bool {
        step.is_multiple_of(self.every) || step == self.schedule.steps
    }

    /// Returns the number of the next step, after `step`, whose sample is visited: one that is written, the last one, or a
    /// multiple of `stride`.
    pub(crate) fn next_visited(&self, step: u64, stride: u64) -> u64 {
        let after = |stride: u64| (step - step % stride).saturating_add(stride);
        after(self.every.max(1)).min(after(stride.max(1))).min(self.schedule.steps)
    }
}
