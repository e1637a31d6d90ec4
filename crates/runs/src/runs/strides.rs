//! How many steps pass between two moments at which a run can stop: [`Strides`].

use collective_integrators::CHECKPOINT;
use core::time::Duration;
use std::time::Instant;

/// The time between two moments is between this one and four times as long, if the steps allow.
const SHORTEST: Duration = Duration::from_millis(500);

/// The numbers of steps between moments, which follow the time that steps take: the rows of a run do not depend on them.
pub(super) struct Strides {
    pub(super) stride: u64,
    /// The least number of steps.
    least: u64,
    last: Instant,
}

impl Strides {
    pub(super) fn new(least: u64) -> Self {
        Self { stride: least, least, last: Instant::now() }
    }

    /// Returns the number of steps to the next moment.
    pub(super) fn next(&mut self) -> u64 {
        let passed = self.last.elapsed();
        self.last = Instant::now();
        if passed < SHORTEST {
            self.stride = (2 * self.stride).min(CHECKPOINT.max(self.least));
        } else if passed > 4 * SHORTEST {
            self.stride = (self.stride / 2).max(self.least);
        }
        self.stride
    }
}
