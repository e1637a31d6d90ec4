//! When a run makes its checkpoint, and when it stops.

use super::recording::Recording;
use super::run_summary::Deviations;
use super::simulate_options::SimulateOptions;
use crate::errors::Error;
use crate::runs::Saved;
use crate::supervision::tiled_run::RESUME;
use collective_integrators::CHECKPOINT;
use std::time::Instant;

/// The checkpoints of a run underway.
pub(super) struct Renewal<'a> {
    options: &'a SimulateOptions<'a>,
    /// The number of steps of the run.
    steps: u64,
    /// The time of the last checkpoint.
    renewed: Instant,
}

impl<'a> Renewal<'a> {
    pub fn new(options: &'a SimulateOptions<'a>, steps: u64) -> Self {
        Self { options, steps, renewed: Instant::now() }
    }

    /// Makes a checkpoint after a step when one is due, and ends the run when it shall stop.
    pub fn pause(
        &mut self,
        step: u64,
        saved: impl FnOnce() -> Saved,
        recording: &mut Recording,
        deviations: &Deviations,
    ) -> Result<(), Error> {
        if !step.is_multiple_of(CHECKPOINT) || step >= self.steps {
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
