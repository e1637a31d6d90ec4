//! The options of a command that cannot be resumed.

use crate::Error;
use std::sync::atomic::{AtomicBool, Ordering};

/// The options of a command that cannot be resumed: requests to stop, and progress.
#[derive(Clone, Copy, Debug)]
pub struct Watch<'a> {
    /// The request to stop: once it is true, the command ends and removes what it has begun.
    pub stop: Option<&'a AtomicBool>,
    /// Whether to show no progress bar.
    pub quiet: bool,
}

/// Ignores requests to stop, and shows no progress bar.
impl Default for Watch<'_> {
    fn default() -> Self {
        Self { stop: None, quiet: true }
    }
}

impl Watch<'_> {
    /// Checks that the command need not end.
    ///
    /// # Errors
    /// [`Error::Interrupted`] if it must end.
    pub(crate) fn require_going(&self) -> Result<(), Error> {
        match self.stop {
            Some(stop) if stop.load(Ordering::Relaxed) => Err(Error::Interrupted { resume: None }),
            _ => Ok(()),
        }
    }
}
