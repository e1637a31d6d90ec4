//! A run in tiles: its options, its threads, and its end.

use crate::errors::Error;
use crate::files::Safeguard;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, Ordering};

/// The argument that resumes a run from what an interrupted one has left beside its output, or begins where there is
/// nothing.
pub(crate) const RESUME: &str = "--resume";

/// The options of a run in tiles.
#[derive(Clone, Copy, Debug)]
pub struct TileOptions<'a> {
    /// Whether to continue from the finished tiles of an interrupted run.
    pub resume: bool,
    /// Whether to discard the finished tiles of an interrupted run.
    pub restart: bool,
    /// The request to stop: once it is true, the run ends, and finished tiles are kept.
    pub stop: Option<&'a AtomicBool>,
    /// The number of threads; by default that of the processors, or what RAYON_NUM_THREADS says.
    pub threads: Option<usize>,
    /// Whether to show no progress bar.
    pub quiet: bool,
    /// The files that the outputs and the tiles must not replace.
    pub safeguard: &'a Safeguard,
}

/// Starts from the beginning, without a progress bar, and replaces only files of the command.
impl Default for TileOptions<'_> {
    fn default() -> Self {
        let safeguard = Safeguard::OWN_FILES;
        Self { resume: false, restart: false, stop: None, threads: None, quiet: true, safeguard }
    }
}

impl TileOptions<'_> {
    /// Returns whether the run shall end.
    pub(crate) fn stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }
}

/// The largest number of threads; more must be a typing error.
const MOST_THREADS: usize = 1024;

/// Creates the threads that share the work: as many as asked for, or else as the processor has or RAYON_NUM_THREADS
/// says.
///
/// # Errors
/// If the number is not in its range, or the system refuses the threads.
pub(crate) fn threads(count: Option<usize>) -> Result<ThreadPool, Error> {
    let Some(threads) = count else {
        return ThreadPoolBuilder::new().build().map_err(Error::Workers);
    };
    if !(1..=MOST_THREADS).contains(&threads) {
        let range = "at least 1 and at most 1024";
        return Err(Error::OutOfRange { name: "threads", range, value: threads as f64 });
    }
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|source| Error::Threads { threads, source })
}

/// Returns the error that a run in tiles was stopped.
pub(crate) fn interrupted() -> Error {
    Error::Interrupted { resume: Some(RESUME.into()) }
}

/// Makes the message of an error whose cause lies outside the run say how to resume the run.
pub(crate) fn resumable(failure: Error) -> Error {
    match failure {
        Error::Write { .. } | Error::Tile { .. } | Error::MissingTile { .. } => {
            Error::Resumable { resume: RESUME.into(), source: Box::new(failure) }
        }
        other => other,
    }
}
