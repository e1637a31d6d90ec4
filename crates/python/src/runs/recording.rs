//! The task of recording a run: times, states, conserved quantities, attitudes, events.

use super::event::{Event, event_failed};
use super::interruption::Interruption;
use super::record::Record;
use super::schedule::Schedule;
use crate::errors::{IntegrationError, failed};
use collective_integrators::{EventError, EventSearch, Integrator, SampleOf, Trajectory};
use lie_poisson::{Quaternion, Vector};
use pyo3::PyResult;

/// Functions of the state that are recorded.
pub(crate) trait Quantities {
    /// Returns the number of quantities.
    fn count(&self) -> usize;

    /// Appends the values of the quantities at a state.
    fn append<M: Vector<Scalar = f64>>(&self, mu: &M, values: &mut Vec<f64>);

    /// Returns the reason why a quantity has no finite value at a state.
    fn without_value<M: Vector<Scalar = f64>>(&self, mu: &M) -> String;
}

/// The task of recording every n-th sample of a run, and the last one.
pub(crate) struct Recording<'a, Q> {
    pub(crate) schedule: &'a Schedule,
    pub(crate) every: u64,
    pub(crate) quantities: Q,
    pub(crate) events: &'a [Event],
    /// Whether the attitude is recorded.
    pub(crate) attitude: bool,
}

impl<Q: Quantities> Recording<'_, Q> {
    /// Records a run of an integrator whose states may have an attitude. It ends where a step fails, or where a quantity or
    /// an event has no value.
    ///
    /// # Errors
    /// Returns `ValueError` if an event has no value at the start, `MemoryError`, and `KeyboardInterrupt`.
    pub(crate) fn follow<I>(
        &self,
        integrator: &I,
        run: Trajectory<'_, I>,
        attitude: impl Fn(&I::State) -> Option<&Quaternion>,
    ) -> PyResult<Record>
    where
        I: Integrator<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        let samples = (self.schedule.steps / self.every).saturating_add(2);
        let attitude_width = if self.attitude { 4 } else { 0 };
        let widths = [self.schedule.start.len(), self.quantities.count(), attitude_width];
        let mut record = Record::new(samples, widths, self.events.len())?;
        let mut searches: Vec<_> =
            self.events.iter().map(|event| event.search(integrator)).collect();
        let interruption = Interruption::default();
        for sample in interruption.until(run) {
            let sample = match sample {
                Ok(sample) => sample,
                Err(error) => {
                    record.failure = Some(failed(error));
                    break;
                }
            };
            record.iterations += sample.iterations as u64;
            let end = match self.observe::<I, _>(&mut searches, &sample, &mut record) {
                Ok(end) => end,
                Err(error) if sample.step == 0 => return Err(event_failed(error, true)),
                Err(error) => {
                    record.failure = Some(event_failed(error, false));
                    break;
                }
            };
            let (last, whole) = (self.schedule.steps, sample.step.is_multiple_of(self.every));
            if end.is_none() && (whole || sample.step >= last) {
                self.keep::<I>(&sample, &attitude, &mut record);
            }
            if let Some(end) = &end {
                record.cut(end.time, widths);
                if record.samples.times.last() != Some(&end.time) {
                    self.keep::<I>(end, &attitude, &mut record);
                }
            }
            if end.is_some() || sample.step >= last || record.failure.is_some() {
                break;
            }
        }
        interruption.or(Ok(record))
    }

    /// Adds the events that a sample completes, and returns the one that ends the run, if any.
    fn observe<I, G>(
        &self,
        searches: &mut [EventSearch<'_, I, G>],
        sample: &SampleOf<I>,
        record: &mut Record,
    ) -> Result<Option<SampleOf<I>>, (usize, EventError)>
    where
        I: Integrator<State: Vector, Momentum: Vector<Scalar = f64>>,
        G: Fn(&I::Momentum) -> f64,
    {
        let mut end: Option<SampleOf<I>> = None;
        for (index, search) in searches.iter_mut().enumerate() {
            let found = search.observe(sample).map_err(|error| (index, error))?;
            let (Some(points), Some(event)) =
                (record.events.get_mut(index), self.events.get(index))
            else {
                continue;
            };
            for occurrence in found.into_iter().flatten() {
                points.times.push(occurrence.time);
                points.states.extend(self.schedule.coordinates(&occurrence.momentum));
                let is_last = points.times.len() as u64 == event.last;
                if is_last && end.as_ref().is_none_or(|end| occurrence.time.abs() < end.time.abs())
                {
                    record.ended_by = Some(index);
                    end = Some(occurrence);
                }
            }
        }
        Ok(end)
    }

    /// Keeps a sample. If a quantity has no finite value there, the run has failed, and only its start is kept.
    fn keep<I>(
        &self,
        sample: &SampleOf<I>,
        attitude: &impl Fn(&I::State) -> Option<&Quaternion>,
        record: &mut Record,
    ) where
        I: Integrator<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        let (momentum, before) = (&sample.momentum, record.values.len());
        self.quantities.append(momentum, &mut record.values);
        if record.values.iter().skip(before).any(|value| !value.is_finite()) {
            let reason = self.quantities.without_value(momentum);
            let text = format!("at t = {}: {reason}", sample.time);
            record.failure = Some(IntegrationError::new_err(text));
            if before > 0 {
                record.values.truncate(before);
                return;
            }
        }
        record.samples.times.push(sample.time);
        record.samples.states.extend(self.schedule.coordinates(momentum));
        if let Some(Quaternion { scalar, vector }) = attitude(&sample.state) {
            record.attitudes.extend([*scalar, vector.x, vector.y, vector.z]);
        }
    }
}
