//! When a run makes its checkpoint, and when it stops.

use super::recording::Recording;
use super::run_summary::Deviations;
use super::simulate_options::SimulateOptions;
use crate::errors::Error;
use crate::runs::{Experiment, Saved};
use crate::supervision::tiled_run::RESUME;
use std::time::Instant;

/// The checkpoints of a run underway.
pub(super) struct Renewal<'a> {
    options: &'a SimulateOptions<'a>,
    /// The number of steps of the run.
    steps: u64,
    /// The number of steps at whose multiples the run can be resumed.
    resumable_after: u64,
    /// The time of the last checkpoint.
    renewed: Instant,
}

impl<'a> Renewal<'a> {
    pub fn new(options: &'a SimulateOptions<'a>, run: &Experiment) -> Self {
        let (steps, resumable_after) = (run.pace.schedule.steps, run.model.resumable_after());
        Self { options, steps, resumable_after, renewed: Instant::now() }
    }

    /// Makes a checkpoint after a step when one is due, and ends the run when it shall stop.
    pub fn pause(
        &mut self,
        step: u64,
        saved: impl FnOnce() -> Saved,
        recording: &mut Recording,
        deviations: &Deviations,
    ) -> Result<(), Error> {
        if !step.is_multiple_of(self.resumable_after) || step >= self.steps {
            return Ok(());
        }
        let stop = !self.options.going();
        if !stop && self.renewed.elapsed() < self.options.interval {
            return Ok(());
        }
        let checkpoint = recording.save(saved(), &deviations.largest)?;
        self.renewed = Instant::now();
        if stop {
            Err(Error::Interrupted { resume: checkpoint.map(|_| RESUME.into()) })
        } else {
            Ok(())
        }
    }
}
