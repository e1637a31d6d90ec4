//! The threads on which many runs are followed at once: [`threads`].

use crate::errors::message;
use core::mem;
use pyo3::exceptions::PyRuntimeError;
use pyo3::{PyResult, Python};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::process;
use std::sync::{Arc, Mutex, PoisonError};

/// The threads that were started last, and the process that started them.
///
/// It is locked only while Python's global lock is held, without which no Python program forks: a child never finds it
/// locked.
static STARTED: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Returns the threads of this process, which are started at the first call. `RAYON_NUM_THREADS` sets their number.
///
/// A process that was forked has none of its parent's threads, and would wait for them for ever. It starts its own.
///
/// # Errors
/// Returns `RuntimeError` if the system refuses the threads.
pub(crate) fn threads(_: Python<'_>) -> PyResult<Arc<ThreadPool>> {
    let process = process::id();
    let mut started = STARTED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((of, threads)) = started.as_ref()
        && *of == process
    {
        return Ok(threads.clone());
    }
    let threads = ThreadPoolBuilder::new().build().map_err(|error| {
        PyRuntimeError::new_err(format!("cannot start threads: {}", message(&error)))
    })?;
    let threads = Arc::new(threads);
    if let Some((_, of_parent)) = started.replace((process, threads.clone())) {
        // Its end would wake threads that are not there, by locks that they may have held at the fork.
        mem::forget(of_parent);
    }
    Ok(threads)
}
