//! The summary of an export.

use crate::files::place::shown;
use serde::Serialize;
use std::fmt;
use std::path::PathBuf;

/// The summary of an export.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExportSummary {
    /// The folder of the files.
    pub out: PathBuf,
    /// The names of the arrays.
    pub arrays: Vec<String>,
    /// The number of samples of each.
    pub samples: u64,
}

impl fmt::Display for ExportSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (samples, arrays) = (self.samples, self.arrays.join(", "));
        writeln!(to, "{samples} samples of {arrays} in {}", shown(&self.out))
    }
}
