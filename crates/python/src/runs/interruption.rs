//! Runs that Ctrl-C ends.

use pyo3::{PyErr, PyResult, Python};
use std::cell::{Cell, RefCell};

/// The number of samples after which a run looks for Ctrl-C.
const BETWEEN_SIGNALS: u64 = 1 << 12;

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
