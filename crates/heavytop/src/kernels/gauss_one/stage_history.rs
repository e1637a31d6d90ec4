//! The stages of one step, from which the next step extrapolates.

use super::compensated_point::CompensatedPoint;
use super::row::{Row, Stages, WIDTH};

/// The stages of the last step, and the point where it ended.
#[derive(Clone, Debug)]
pub(super) struct StageHistory {
    first: Stages,
    second: Stages,
    /// Whether `first` holds the last step; the other one is free.
    last_is_first: bool,
    /// The number of sweeps of the last step; 0 if there was none.
    sweeps: usize,
    end: CompensatedPoint,
    step: f64,
}

impl StageHistory {
    pub(super) fn new() -> Self {
        let (first, second) = ([Row::ZERO; WIDTH], [Row::ZERO; WIDTH]);
        Self {
            first,
            second,
            last_is_first: true,
            sweeps: 0,
            end: CompensatedPoint::ZERO,
            step: 0.0,
        }
    }

    /// Forgets the last step.
    pub(super) fn forget(&mut self) {
        self.sweeps = 0;
    }

    /// Returns the stages of the last step, and the storage for those of the next one.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn stages(&mut self) -> (&mut Stages, &mut Stages) {
        let Self { first, second, .. } = self;
        if self.last_is_first { (first, second) } else { (second, first) }
    }

    /// Returns the number of sweeps of the last step if a step from `start` continues it.
    ///
    /// Otherwise it returns 0 and sets the stages of the last step to 0: the first guess is then z at every
    /// stage.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn recall(&mut self, start: &CompensatedPoint, step: f64) -> usize {
        if self.sweeps == 0 || self.step != step || !self.end.is(start) {
            self.sweeps = 0;
            *self.stages().0 = [Row::ZERO; WIDTH];
        }
        self.sweeps
    }

    /// Records the stages that were found as those of the last step.
    ///
    /// The step ended with χ + bψ, b = `slid`; the stages slide with it.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn keep(&mut self, end: &CompensatedPoint, step: f64, sweeps: usize, slid: f64) {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The derivatives of χ + bψ are ℓ_χ + bℓ_ψ.
    #[test]
    fn stages_slide_with_the_point() {
        let mut history = StageHistory::new();
        let row = |c: usize| core::array::from_fn(|j| (c * WIDTH + j) as f64 - 30.0);
        *history.stages().1 = core::array::from_fn(|c| Row(row(c)));
        history.keep(&CompensatedPoint::ZERO, 0.1, 5, 0.5);
        let kept = *history.stages().0;
        for c in 0..4 {
            let (chi, psi): ([f64; WIDTH], [f64; WIDTH]) = (row(c), row(c + 4));
            assert_eq!(kept[c].0, core::array::from_fn(|j| chi[j] + 0.5 * psi[j]));
            assert_eq!(kept[c + 4].0, psi);
        }
        assert_eq!(history.recall(&CompensatedPoint::ZERO, 0.1), 5);
        // Control: a step of another length continues nothing.
        assert_eq!(history.recall(&CompensatedPoint::ZERO, 0.2), 0);
        assert_eq!(history.stages().0, &[Row::ZERO; WIDTH]);
    }
}
