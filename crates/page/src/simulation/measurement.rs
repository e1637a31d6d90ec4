//! The deviations of the invariants from their values at the start.

use crate::error::PageError;
use crate::motions::damped::Frictions;
use crate::records::deviation_record::{DeviationRecord, MOST_INVARIANTS};
use heavytop::{HeavyTop, Invariant};
use lie_poisson::Se3Dual;

/// The span of time of a column of a new record, s. Columns get longer as a run does.
const SPAN: f64 = 0.02;

/// The invariants of a top, with their values at the start, now, and in between.
///
/// A friction changes them, too. Its part is known exactly for each step and is counted apart, so that the deviations
/// are the errors of the method alone.
#[derive(Clone, Debug)]
pub(crate) struct Measurement {
    top: HeavyTop,
    invariants: Vec<Invariant>,
    initial: [f64; MOST_INVARIANTS],
    values: [f64; MOST_INVARIANTS],
    /// The changes by friction until the beginning of the last step, and in it.
    by_friction: [[f64; MOST_INVARIANTS]; 2],
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
        let by_friction = [initial; 2];
        let mut empty =
            Self { top: *top, invariants, initial, values: initial, by_friction, record };
        empty.initial = empty.values_at(start, time)?;
        empty.values = empty.initial;
        Ok(empty)
    }

    /// Begins a measurement at the end of the last step.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(crate) fn anew(&self, now: &Se3Dual, time: f64) -> Result<Self, PageError> {
        let [_, last] = self.by_friction;
        // The run may still go back to a time within the last step.
        Ok(Self {
            by_friction: [last.map(|change| -change), last],
            ..Self::new(&self.top, now, time)?
        })
    }

    /// Forgets an invariant that the top has in some states alone, as the friction leaves these states. It is the last one.
    pub(crate) fn keep_general(&mut self) {
        let general = self.top.invariants().len();
        self.invariants.truncate(general);
        let [before, last] = &mut self.by_friction;
        for numbers in [&mut self.initial, &mut self.values, before, last] {
            numbers.iter_mut().skip(general).for_each(|number| *number = 0.0);
        }
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

    /// Returns the changes of the invariants by friction.
    pub(crate) fn by_friction(&self) -> [f64; MOST_INVARIANTS] {
        let [before, last] = &self.by_friction;
        std::array::from_fn(|i| before[i] + last[i])
    }

    /// Returns the values of the invariants minus those at the start and minus the changes by friction.
    pub(crate) fn deviations(&self) -> [f64; MOST_INVARIANTS] {
        let by_friction = self.by_friction();
        std::array::from_fn(|i| self.values[i] - self.initial[i] - by_friction[i])
    }

    /// Measures the state after a step, in which the friction has done this.
    ///
    /// # Errors
    /// Returns [`PageError::NotFinite`] if an invariant is too large for a number. Nothing is recorded then.
    pub(crate) fn measure(
        &mut self,
        mu: &Se3Dual,
        frictions: Option<Frictions>,
        time: f64,
    ) -> Result<(), PageError> {
        let changes = self.changes(frictions, time)?;
        self.values = self.values_at(mu, time)?;
        self.by_friction = [self.by_friction(), changes];
        self.record.push(time, &self.deviations());
        Ok(())
    }

    /// Measures the state at a time within the last step, from which the run goes on, and until which the friction has done
    /// this in the step.
    ///
    /// # Errors
    /// As [`measure`](Self::measure).
    pub(crate) fn go_back(
        &mut self,
        mu: &Se3Dual,
        frictions: Option<Frictions>,
        time: f64,
    ) -> Result<(), PageError> {
        let changes = self.changes(frictions, time)?;
        self.values = self.values_at(mu, time)?;
        self.by_friction[1] = changes;
        Ok(())
    }

    /// Returns the changes of the invariants by what the friction has done.
    fn changes(
        &self,
        frictions: Option<Frictions>,
        time: f64,
    ) -> Result<[f64; MOST_INVARIANTS], PageError> {
        let mut changes = [0.0; MOST_INVARIANTS];
        for [before, after] in frictions.iter().flatten() {
            let (before, after) = (self.values_at(before, time)?, self.values_at(after, time)?);
            for ((change, before), after) in changes.iter_mut().zip(before).zip(after) {
                *change += after - before;
            }
        }
        Ok(changes)
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
