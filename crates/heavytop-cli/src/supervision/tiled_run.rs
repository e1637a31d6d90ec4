//! A run in tiles: its options, its threads, and its end.

use crate::Error;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, Ordering};

/// The argument that resumes a run.
pub(super) const RESUME: &str = "--resume";

/// The options of a run in tiles.
#[derive(Clone, Copy, Debug)]
pub struct TileOptions<'a> {
    /// Whether to continue from the finished tiles of an interrupted run.
    pub resume: bool,
    /// Whether to discard the finished tiles of an interrupted run.
    pub restart: bool,
    /// The request to stop: once it is true, the run ends, and finished tiles are kept.
    pub stop: Option<&'a AtomicBool>,
    /// Whether to show no progress bar.
    pub quiet: bool,
}

/// Starts from the beginning, without a progress bar.
impl Default for TileOptions<'_> {
    fn default() -> Self {
        Self { resume: false, restart: false, stop: None, quiet: true }
    }
}

impl TileOptions<'_> {
    /// Returns whether the run shall end.
    pub(crate) fn stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }
}

/// Creates the threads that compute tiles: as many as the processor has, or as RAYON_NUM_THREADS says.
///
/// # Errors
/// If the system refuses the threads.
pub(crate) fn threads() -> Result<ThreadPool, Error> {
    ThreadPoolBuilder::new().build().map_err(Error::Workers)
}

/// Returns the error that a run in tiles was stopped.
pub(crate) fn interrupted() -> Error {
    Error::Interrupted { resume: Some(RESUME.into()) }
}

/// Adds to an error with a cause outside the run that the run can be resumed.
pub(crate) fn resumable(failure: Error) -> Error {
    match failure {
        Error::Write { .. } | Error::Tile { .. } => {
            Error::Resumable { resume: RESUME.into(), source: Box::new(failure) }
        }
        other => other,
    }
}
