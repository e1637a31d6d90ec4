//! How a command is accompanied that cannot be resumed.

use crate::Error;
use std::sync::atomic::{AtomicBool, Ordering};

/// Who sees how far it is, and who may stop it.
#[derive(Clone, Copy, Debug)]
pub struct Watch<'a> {
    /// Once this is true the command ends, and leaves nothing of what it has begun.
    pub stop: Option<&'a AtomicBool>,
    /// Whether to show no progress bar.
    pub quiet: bool,
}

/// By nobody, and quietly.
impl Default for Watch<'_> {
    fn default() -> Self {
        Self { stop: None, quiet: true }
    }
}

impl Watch<'_> {
    /// Checks that the command shall not end.
    ///
    /// # Errors
    /// [`Error::Interrupted`] if it shall.
    pub(crate) fn require_going(&self) -> Result<(), Error> {
        match self.stop {
            Some(stop) if stop.load(Ordering::Relaxed) => Err(Error::Interrupted { resume: None }),
            _ => Ok(()),
        }
    }
}
