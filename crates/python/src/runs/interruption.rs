//! Runs that Ctrl-C ends.

use crate::threads::threads;
use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use pyo3::exceptions::PyRuntimeError;
use pyo3::{PyErr, PyResult, Python};
use std::cell::{Cell, RefCell};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;

/// The number of samples after which a run looks for Ctrl-C.
const BETWEEN_SIGNALS: u64 = 1 << 12;

/// The time after which the thread of Python looks for Ctrl-C while others work.
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);

/// Looks for Ctrl-C now and then.
#[derive(Default)]
pub(crate) struct Interruption {
    samples: Cell<u64>,
    error: RefCell<Option<PyErr>>,
}

impl Interruption {
    /// Returns the samples until Ctrl-C.
    pub(crate) fn until<J: Iterator>(&self, samples: J) -> impl Iterator<Item = J::Item> {
        samples.take_while(|_| {
            self.samples.set(self.samples.get() + 1);
            if self.samples.get().is_multiple_of(BETWEEN_SIGNALS) {
                self.error.replace(Python::attach(|py| py.check_signals()).err());
            }
            self.error.borrow().is_none()
        })
    }

    /// Returns the result of what read the samples.
    ///
    /// # Errors
    /// Returns `KeyboardInterrupt`, or what the program's handler raised, if Ctrl-C ended the samples.
    pub(crate) fn or<T>(self, result: PyResult<T>) -> PyResult<T> {
        match self.error.into_inner() {
            Some(error) => Err(error),
            None => result,
        }
    }
}

/// Runs a task on the [threads] of the process, while the thread of Python looks for Ctrl-C and then sets the flag that the
/// task reads.
///
/// # Errors
/// Returns `RuntimeError` if there are no threads. Returns `KeyboardInterrupt`, or what the program's handler raised, once
/// the task has ended.
pub(crate) fn until_interrupted<T: Send>(
    py: Python<'_>,
    task: impl FnOnce(&AtomicBool) -> T + Send,
) -> PyResult<T> {
    let (threads, stop, mut error) = (threads(py)?, AtomicBool::new(false), None);
    let done = py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = channel::<()>();
            let stop = &stop;
            let worker = scope.spawn(move || {
                let result = threads.install(|| task(stop));
                drop(sender);
                result
            });
            // The channel is closed when the task ends.
            while receiver.recv_timeout(BETWEEN_LOOKS) == Err(RecvTimeoutError::Timeout) {
                if let Err(interrupt) = Python::attach(|py| py.check_signals()) {
                    stop.store(true, Ordering::Relaxed);
                    error.get_or_insert(interrupt);
                }
            }
            worker.join()
        })
    });
    match error {
        Some(error) => Err(error),
        None => done.map_err(|_| PyRuntimeError::new_err("a thread of the computation failed")),
    }
}
