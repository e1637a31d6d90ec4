//! How far each motion of a sweep is followed, and what is measured.

use crate::configuration::Observable;
use crate::runs::Schedule;

/// The steps of each motion, and what is measured of it.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::sweep) struct Course {
    pub schedule: Schedule,
    pub observables: Vec<Observable>,
}

impl Course {
    /// Returns the number of tangent vectors that the observables need.
    pub fn tangents(&self) -> usize {
        self.observables.iter().map(|observable| observable.tangents()).max().unwrap_or(0)
    }
}
