//! Runs that Ctrl-C ends.

use crate::threads::threads;
use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use pyo3::exceptions::PyRuntimeError;
use pyo3::{PyErr, PyResult, Python};
use std::cell::{Cell, RefCell};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Instant;

/// The number of steps after which a run looks for Ctrl-C.
pub(crate) const BETWEEN_SIGNALS: u64 = 1 << 12;

/// The time after which the thread of Python looks for Ctrl-C, while others work or in between.
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);

/// Looks for Ctrl-C now and then.
pub(crate) struct Interruption {
    /// The number of steps since the last look.
    steps: Cell<u64>,
    looked: Cell<Instant>,
    error: RefCell<Option<PyErr>>,
}

impl Default for Interruption {
    fn default() -> Self {
        Self { steps: Cell::new(0), looked: Cell::new(Instant::now()), error: RefCell::new(None) }
    }
}

impl Interruption {
    /// Returns whether a computation of the thread of Python, which asks every few steps, is to go on. It looks for Ctrl-C
    /// at most every 50 ms, since another thread of Python may have to be waited for.
    pub(crate) fn is_going(&self) -> bool {
        if self.looked.get().elapsed() > BETWEEN_LOOKS {
            self.look();
            self.looked.set(Instant::now());
        }
        self.error.borrow().is_none()
    }

    fn look(&self) {
        if self.error.borrow().is_none() {
            self.error.replace(Python::attach(|py| py.check_signals()).err());
        }
    }

    /// Returns the samples until Ctrl-C.
    pub(crate) fn until<J: Iterator>(&self, samples: J) -> impl Iterator<Item = J::Item> {
        samples.take_while(|_| self.goes_on_after(1))
    }

    /// Returns whether a run that has made so many more steps is to go on.
    pub(crate) fn goes_on_after(&self, steps: u64) -> bool {
        self.steps.set(self.steps.get().saturating_add(steps));
        if self.steps.get() >= BETWEEN_SIGNALS {
            self.steps.set(0);
            self.look();
        }
        self.error.borrow().is_none()
    }

    /// Returns the result of what read the samples, or asked whether to go on.
    ///
    /// # Errors
    /// Returns `KeyboardInterrupt`, or what the program's handler raised, if Ctrl-C ended it.
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
