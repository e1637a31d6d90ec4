//! What a step leaves behind for the next one.

use super::point::Point;
use super::row::{Row, Stages, WIDTH};

/// The stages of the last step, and where it ended.
#[derive(Clone, Debug)]
pub(super) struct Memory {
    first: Stages,
    second: Stages,
    /// Which of the two belongs to the last step; the other one is free.
    last_is_first: bool,
    /// The sweeps that the last step took; 0 if there was none.
    sweeps: usize,
    end: Point,
    step: f64,
}

impl Memory {
    pub(super) fn new() -> Self {
        let (first, second) = ([Row::ZERO; WIDTH], [Row::ZERO; WIDTH]);
        Self { first, second, last_is_first: true, sweeps: 0, end: Point::ZERO, step: 0.0 }
    }

    /// Forgets the last step.
    pub(super) fn forget(&mut self) {
        self.sweeps = 0;
    }

    /// The stages of the last step, and room for those to be found.
    #[inline(always)]
    pub(super) fn stages(&mut self) -> (&mut Stages, &mut Stages) {
        let Self { first, second, .. } = self;
        if self.last_is_first { (first, second) } else { (second, first) }
    }

    /// The sweeps of the last step if one from `start` continues it. Otherwise 0, and the stages
    /// of the last step are 0: the guess is then z at every stage.
    #[inline(always)]
    pub(super) fn recall(&mut self, start: &Point, step: f64) -> usize {
        if self.sweeps == 0 || self.step != step || !self.end.is(start) {
            self.sweeps = 0;
            *self.stages().0 = [Row::ZERO; WIDTH];
        }
        self.sweeps
    }

    /// What was to be found is the last step now. It ended with χ + bψ, b = `slid`, where the
    /// stages go too.
    #[inline(always)]
    pub(super) fn keep(&mut self, end: &Point, step: f64, sweeps: usize, slid: f64) {
        (self.end, self.step, self.sweeps) = (*end, step, sweeps);
        self.last_is_first = !self.last_is_first;
        if slid != 0.0 {
            self.slide(slid);
        }
    }

    #[cold]
    fn slide(&mut self, b: f64) {
        let (chi, psi) = self.stages().0.split_at_mut(4);
        for (chi, psi) in chi.iter_mut().zip(psi) {
            for (x, y) in chi.0.iter_mut().zip(psi.0) {
                *x += b * y;
            }
        }
    }
}
