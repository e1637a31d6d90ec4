//! The deviations of the invariants from their values at the start.

use crate::error::PageError;
use crate::records::deviation_record::{DeviationRecord, MOST_INVARIANTS};
use heavytop::{HeavyTop, Invariant};
use lie_poisson::Se3Dual;

/// The span of time of a column of a new record, s. Columns get longer as a run does.
const SPAN: f64 = 0.02;

/// The invariants of a top, with their values at the start, now, and in between.
#[derive(Clone, Debug)]
pub(crate) struct Measurement {
    top: HeavyTop,
    invariants: Vec<Invariant>,
    initial: [f64; MOST_INVARIANTS],
    values: [f64; MOST_INVARIANTS],
    record: DeviationRecord,
}

impl Measurement {
    /// Begins a measurement of a top.
    ///
    /// # Errors
    /// Returns [`PageError::NotFinite`] if an invariant is too large for a number.
    pub(crate) fn new(top: &HeavyTop, start: &Se3Dual, time: f64) -> Result<Self, PageError> {
        let mut invariants = top.invariants_from(start);
        invariants.truncate(MOST_INVARIANTS);
        let (initial, record) = ([0.0; MOST_INVARIANTS], DeviationRecord::new(SPAN));
        let mut empty = Self { top: *top, invariants, initial, values: initial, record };
        empty.initial = empty.values_at(start, time)?;
        empty.values = empty.initial;
        Ok(empty)
    }

    pub(crate) fn invariants(&self) -> &[Invariant] {
        &self.invariants
    }

    /// Returns the values at the start: h, f₁, f₂ and those after them.
    pub(crate) fn initial(&self) -> &[f64; MOST_INVARIANTS] {
        &self.initial
    }

    pub(crate) fn values(&self) -> &[f64; MOST_INVARIANTS] {
        &self.values
    }

    pub(crate) fn record(&self) -> &DeviationRecord {
        &self.record
    }

    /// Returns the values of the invariants minus those at the start.
    pub(crate) fn deviations(&self) -> [f64; MOST_INVARIANTS] {
        std::array::from_fn(|i| self.values[i] - self.initial[i])
    }

    /// Measures the state after a step.
    ///
    /// # Errors
    /// Returns [`PageError::NotFinite`] if an invariant is too large for a number. Nothing is recorded then.
    pub(crate) fn measure(&mut self, mu: &Se3Dual, time: f64) -> Result<(), PageError> {
        self.values = self.values_at(mu, time)?;
        self.record.push(time, &self.deviations());
        Ok(())
    }

    fn values_at(&self, mu: &Se3Dual, time: f64) -> Result<[f64; MOST_INVARIANTS], PageError> {
        let mut values = [0.0; MOST_INVARIANTS];
        for (value, invariant) in values.iter_mut().zip(&self.invariants) {
            *value = invariant.value(&self.top, mu);
            if !value.is_finite() {
                return Err(PageError::NotFinite { symbol: invariant.symbol(), time });
            }
        }
        Ok(values)
    }
}
