//! The time of a run whose step changes.

/// The time of a run: that of its last change of the step, plus the steps since then.
///
/// A run without changes has the times `n as f64 * step` of a trajectory, to the last bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clock {
    origin: f64,
    made: u64,
    step: f64,
    /// The size of the last step, which may be that before the change.
    last: f64,
    /// The number of steps since the throw.
    total: u64,
}

impl Clock {
    pub(crate) fn new(step: f64) -> Self {
        Self { origin: 0.0, made: 0, step, last: 0.0, total: 0 }
    }

    pub(crate) fn step(&self) -> f64 {
        self.step
    }

    pub(crate) fn total(&self) -> u64 {
        self.total
    }

    /// Returns the time after the last step, s.
    pub(crate) fn time(&self) -> f64 {
        self.origin + self.made as f64 * self.step
    }

    /// Returns the time since the beginning of the last step, from 0 to its size.
    pub(crate) fn since_last_step(&self, time: f64) -> f64 {
        (time - (self.time() - self.last)).clamp(0.0, self.last)
    }

    /// Adds one step to the count.
    pub(crate) fn advance(&mut self) {
        self.made = self.made.saturating_add(1);
        self.total = self.total.saturating_add(1);
        self.last = self.step;
    }

    /// Continues with another step.
    pub(crate) fn change_step(&mut self, step: f64) {
        (self.origin, self.made, self.step) = (self.time(), 0, step);
    }

    /// Continues from a time within the last step, as if the run began there.
    pub(crate) fn go_back(&mut self, time: f64) {
        let start = self.time() - self.last;
        (self.origin, self.made) = (start + self.since_last_step(time), 0);
        self.last = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_a_run_whose_step_changes() {
        let mut clock = Clock::new(0.1);
        (0..3).for_each(|_| clock.advance());
        assert_eq!(clock.time(), 3.0 * 0.1);
        clock.change_step(0.5);
        // The last step is that before the change.
        assert_eq!((clock.time(), clock.since_last_step(9.0)), (3.0 * 0.1, 0.1));
        clock.advance();
        assert_eq!((clock.time(), clock.since_last_step(0.55)), (0.8, 0.25));
        clock.go_back(0.55);
        assert_eq!((clock.time(), clock.since_last_step(0.0)), (0.55, 0.0));
        assert_eq!(clock.total(), 4);
    }
}
