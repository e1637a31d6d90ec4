//! How a run is accompanied.

use super::checkpoint::Checkpoint;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// How a run is accompanied.
#[derive(Clone, Copy, Debug)]
pub struct SimulateOptions<'a> {
    /// What it goes on from.
    pub resume: Option<&'a Checkpoint>,
    /// Whether the checkpoint of an interrupted run, if there is one, is discarded.
    pub restart: bool,
    /// After this time a checkpoint is renewed, at the next step that can have one.
    pub interval: Duration,
    /// Once this is true the run ends with a checkpoint.
    pub stop: Option<&'a AtomicBool>,
    /// Whether to show no progress bar.
    pub quiet: bool,
}

/// From the first step, with a checkpoint each minute, and quietly.
impl Default for SimulateOptions<'_> {
    fn default() -> Self {
        let interval = Duration::from_secs(60);
        Self { resume: None, restart: false, interval, stop: None, quiet: true }
    }
}
