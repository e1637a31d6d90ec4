//! The options of `simulate`: checkpoints, requests to stop, and progress.

use super::checkpoints::checkpoint::Checkpoint;
use crate::errors::Error;
use crate::files::Safeguard;
use crate::supervision::Progress;
use crate::supervision::tiled_run::RESUME;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// What is measured of a whole run, once it is complete, by more of its steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Measures {
    /// Whether to check it by runs with half the step and with twice the step.
    pub check: bool,
    /// Whether to measure what forces supply to the conserved quantities.
    pub balance: bool,
}

/// The options of a run: checkpoints, requests to stop, measures, and progress.
#[derive(Clone, Copy, Debug)]
pub struct SimulateOptions<'a> {
    /// The checkpoint to continue from.
    pub resume: Option<&'a Checkpoint>,
    /// Whether to discard the checkpoint of an interrupted run, if there is one.
    pub restart: bool,
    /// The time after which a checkpoint is renewed, at the next step that can have one.
    pub interval: Duration,
    /// The request to stop: once it is true, the run ends with a checkpoint.
    pub stop: Option<&'a AtomicBool>,
    /// What is measured of the whole run, once it is complete.
    pub measures: Measures,
    /// Whether to show no progress bar.
    pub quiet: bool,
    /// The files that the output, and what is written on the way to it, must not replace.
    pub safeguard: &'a Safeguard,
}

impl SimulateOptions<'_> {
    /// Returns whether there is no request to stop.
    pub(super) fn going(&self) -> bool {
        !self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }

    /// Makes an estimate of the error, which ends early at a request to stop, and shows meanwhile that it is at work.
    ///
    /// # Errors
    /// If there is a request to stop, and the run continues from a checkpoint: it stays there. Another run goes on to its
    /// first row, where it stops with a checkpoint.
    pub(super) fn estimated<T>(
        &self,
        estimate: impl FnOnce(&dyn Fn() -> bool) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let _shown = Progress::estimating(self.quiet);
        let estimated = estimate(&|| self.going())?;
        match self.resume {
            Some(_) if !self.going() => Err(Error::Interrupted { resume: Some(RESUME.into()) }),
            _ => Ok(estimated),
        }
    }
}

/// Starts from the first step, with a checkpoint each minute and no progress bar, and replaces only files of the command.
impl Default for SimulateOptions<'_> {
    fn default() -> Self {
        let interval = Duration::from_secs(60);
        let safeguard = Safeguard::OWN_FILES;
        Self {
            resume: None,
            restart: false,
            interval,
            stop: None,
            measures: Measures::default(),
            quiet: true,
            safeguard,
        }
    }
}
