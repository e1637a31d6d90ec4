//! The options of a command that cannot be resumed.

use crate::errors::Error;
use crate::files::Safeguard;
use std::sync::atomic::{AtomicBool, Ordering};

/// The options of a command that cannot be resumed: requests to stop, progress, and the files that it must not replace.
#[derive(Clone, Copy, Debug)]
pub struct Watch<'a> {
    /// The request to stop: once it is true, the command ends and removes what it has begun.
    pub stop: Option<&'a AtomicBool>,
    /// Whether to show no progress bar.
    pub quiet: bool,
    /// The files that the outputs must not replace.
    pub safeguard: &'a Safeguard,
}

/// Ignores requests to stop, shows no progress bar, and replaces only files of the command.
impl Default for Watch<'_> {
    fn default() -> Self {
        Self { stop: None, quiet: true, safeguard: Safeguard::OWN_FILES }
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
