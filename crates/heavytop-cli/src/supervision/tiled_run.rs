//! A run in tiles: how it is accompanied, its threads, and how it goes on after an interruption.

use crate::Error;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, Ordering};

/// The argument by which a run goes on.
pub(super) const RESUME: &str = "--resume";

/// How a run in tiles is accompanied.
#[derive(Clone, Copy, Debug)]
pub struct TileOptions<'a> {
    /// Whether it goes on from the finished tiles of an interrupted run.
    pub resume: bool,
    /// Whether those are discarded.
    pub restart: bool,
    /// Once this is true the run ends; what is finished is kept.
    pub stop: Option<&'a AtomicBool>,
    /// Whether to show no progress bar.
    pub quiet: bool,
}

/// From the start, and quietly.
impl Default for TileOptions<'_> {
    fn default() -> Self {
        Self { resume: false, restart: false, stop: None, quiet: true }
    }
}

impl TileOptions<'_> {
    /// Whether the run shall end.
    pub(crate) fn stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }
}

/// The threads that finish tiles: as many as the processor has, or as RAYON_NUM_THREADS says.
///
/// # Errors
/// If the system refuses them.
pub(crate) fn threads() -> Result<ThreadPool, Error> {
    ThreadPoolBuilder::new().build().map_err(Error::Workers)
}

/// That a run in tiles was stopped.
pub(crate) fn interrupted() -> Error {
    Error::Interrupted { resume: Some(RESUME.into()) }
}

/// Says of what failed for want of something outside the run that it can go on.
pub(crate) fn resumable(failure: Error) -> Error {
    match failure {
        Error::Write { .. } | Error::Tile { .. } => {
            Error::Resumable { resume: RESUME.into(), source: Box::new(failure) }
        }
        other => other,
    }
}
