//! The problem of a benchmark: tops, their starts, and their states at two times.

use crate::error::RunFailure;
use collective_integrators::{IntegrationError, Start};
use heavytop::methods::{MethodError, SchemeName};
use heavytop::{CollectiveGauss, HeavyTop};
use lie_poisson::{BlockScales, Se3Dual, Vector};

/// The first of the two times at which errors are measured, s.
pub const EARLY: f64 = 10.0;

/// The step of the reference, a Gauss method of order 16, s.
const STEP: f64 = 0.125;

/// A top with one start or many, and reference states at two times.
#[derive(Clone, Debug, PartialEq)]
pub struct TimedProblem {
    /// The top that all starts share.
    pub top: HeavyTop,
    /// The end of the runs, s.
    pub end: f64,
    /// The number of tops.
    pub tops: u64,
    /// The starts of the tops; top number n has start number n modulo their number.
    pub starts: Vec<Se3Dual>,
    /// The states of the starts after 10 s.
    pub early: Vec<Se3Dual>,
    /// The states of the starts at the end.
    pub late: Vec<Se3Dual>,
}

impl TimedProblem {
    /// Computes the references of the given starts until `end` (s), a multiple of ⅛ s that is more than 10 s.
    ///
    /// The method is the collective Gauss method of order 16 with steps of ⅛ s. Its errors are about 1e-13 for tops
    /// that turn as fast as the paper's.
    ///
    /// # Errors
    /// If the end is at most 10 s or not finite, or a reference cannot be computed.
    pub fn with_references(
        top: HeavyTop,
        end: f64,
        starts: Vec<Se3Dual>,
    ) -> Result<Self, RunFailure> {
        if !(end > EARLY && end.is_finite()) {
            return Err(RunFailure::EarlyEnd { end });
        }
        let gauss = CollectiveGauss::new(8, top)
            .map_err(|reason| MethodError::Scheme { scheme: SchemeName::Gauss(8), reason })?;
        let failed =
            |reason: IntegrationError| RunFailure::Timed { name: "reference".to_owned(), reason };
        let (mut early, mut late) = (Vec::new(), Vec::new());
        for start in &starts {
            let mut run = gauss.trajectory(start, STEP)?;
            let mut after = |time: f64, passed: f64| {
                let steps = ((time - passed) / STEP).round() as usize;
                run.nth(steps.saturating_sub(1)).transpose().map_err(failed)
            };
            // The first sample is the start.
            early.extend(after(EARLY + STEP, 0.0)?.map(|sample| sample.momentum));
            late.extend(after(end, EARLY)?.map(|sample| sample.momentum));
        }
        let tops = starts.len() as u64;
        Ok(Self { top, end, tops, starts, early, late })
    }

    /// Returns the problem with its first `count` tops at most.
    pub(super) fn first(&self, count: usize) -> Self {
        let first = |states: &[Se3Dual]| states.iter().take(count).copied().collect();
        let [starts, early, late] =
            [&self.starts, &self.early, &self.late].map(|states| first(states));
        Self {
            top: self.top,
            end: self.end,
            tops: self.tops.min(count as u64),
            starts,
            early,
            late,
        }
    }

    /// Returns the largest |Π| and |Γ| of the start and of the references of each top, in whose units errors are relative.
    pub(super) fn sizes(&self) -> impl Iterator<Item = BlockScales<Se3Dual>> {
        let references = self.early.iter().zip(&self.late);
        self.starts.iter().zip(references).map(|(start, (early, late))| {
            let mut sizes = BlockScales::of(start);
            sizes.include(early);
            sizes.include(late);
            sizes
        })
    }

    /// Returns the start of the top with number `index`. It is NaN if there are no starts.
    #[must_use]
    pub fn start(&self, index: u64) -> Se3Dual {
        let place = index % (self.starts.len() as u64).max(1);
        // There are no more starts than memory holds.
        let start = self.starts.get(place as usize).copied();
        start.unwrap_or_else(|| Se3Dual::from_coordinates(|_| f64::NAN))
    }
}
