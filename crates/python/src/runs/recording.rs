//! The recording of a run: times, states, conserved quantities, attitudes, events.

use super::event::{Event, event_failed};
use super::interruption::{BETWEEN_SIGNALS, Interruption};
use super::record::Record;
use crate::errors::{IntegrationError, failed};
use collective_integrators::{AnyIntegrator, EventError, EventSearch, SampleOf, Trajectory};
use lie_poisson_runs::{Conserved, Schedule, TimedIntegrator, TimedState};
use pyo3::PyResult;

/// A sample of a run.
type Sample = SampleOf<AnyIntegrator>;

/// The recording of every n-th sample of a run, and of the last one.
pub(crate) struct Recording<'a> {
    pub(crate) schedule: Schedule,
    pub(crate) every: u64,
    pub(crate) conserved: &'a dyn Conserved,
    pub(crate) events: &'a [Event<'a>],
    /// The numbers of coordinates and of conserved quantities.
    pub(crate) widths: [usize; 2],
    /// Whether the attitude is recorded, which is in the last four coordinates of the states.
    pub(crate) attitude: bool,
}

impl Recording<'_> {
    /// Records a run of an integrator. It ends where a step fails, or where a quantity or
    /// an event has no value.
    ///
    /// # Errors
    /// Returns `ValueError` if an event has no value at the start, `MemoryError`, and `KeyboardInterrupt`.
    pub(crate) fn follow(
        &self,
        integrator: &AnyIntegrator,
        mut run: Trajectory<'_, AnyIntegrator>,
    ) -> PyResult<Record> {
        let samples = (self.schedule.steps / self.every).saturating_add(2);
        let attitude_width = if self.attitude { 4 } else { 0 };
        let [dimension, count] = self.widths;
        let widths = [dimension, count, attitude_width];
        let mut record = Record::new(samples, widths, self.events.len())?;
        let timed = TimedIntegrator::new(integrator);
        let mut searches: Vec<_> = self.events.iter().map(|event| event.search(&timed)).collect();
        let interruption = Interruption::default();
        let mut skipped = 0;
        while let Some(sample) = run.nth(skipped) {
            if !interruption.goes_on_after(skipped as u64 + 1) {
                break;
            }
            let sample = match sample {
                Ok(sample) => sample,
                Err(error) => {
                    record.failure = Some(failed(error));
                    break;
                }
            };
            record.iterations += sample.iterations as u64;
            let end = match self.observe(&mut searches, &sample, &mut record) {
                Ok(end) => end,
                Err(error) => {
                    if let Some(raised) = self.events.get(error.0).and_then(Event::raised) {
                        return Err(raised);
                    }
                    let is_start = sample.step == 0;
                    let failure = event_failed(error, is_start);
                    if is_start {
                        return Err(failure);
                    }
                    record.failure = Some(failure);
                    break;
                }
            };
            let (last, whole) = (self.schedule.steps, sample.step.is_multiple_of(self.every));
            if end.is_none() && (whole || sample.step >= last) {
                self.keep(&sample, &mut record);
            }
            if let Some(end) = &end {
                record.cut(end.time, widths);
                if record.samples.times.last() != Some(&end.time) {
                    self.keep(end, &mut record);
                }
            }
            if end.is_some() || sample.step >= last || record.failure.is_some() {
                break;
            }
            skipped = self.steps_after(sample.step) as usize - 1;
        }
        interruption.or(Ok(record))
    }

    /// Returns the number of steps from one sample to the next: one if there are events, otherwise as many as lead to one that
    /// is kept, or at which the run looks for Ctrl-C.
    fn steps_after(&self, step: u64) -> u64 {
        let (kept, last) = (self.every - step % self.every, self.schedule.steps - step);
        if self.events.is_empty() { kept.min(last).min(BETWEEN_SIGNALS) } else { 1 }
    }

    /// Adds the events that a sample completes, and returns the one that ends the run, if any.
    fn observe<'b>(
        &self,
        searches: &mut [EventSearch<'b, TimedIntegrator<'b>, impl Fn(&TimedState) -> f64>],
        sample: &Sample,
        record: &mut Record,
    ) -> Result<Option<Sample>, (usize, EventError)> {
        let mut end: Option<Sample> = None;
        if searches.is_empty() {
            return Ok(end);
        }
        let timed = TimedIntegrator::sample(sample);
        for (index, search) in searches.iter_mut().enumerate() {
            let found = search.observe(&timed).map_err(|error| (index, error))?;
            let (Some(points), Some(event)) =
                (record.events.get_mut(index), self.events.get(index))
            else {
                continue;
            };
            for occurrence in found.into_iter().flatten().map(TimedIntegrator::untimed) {
                points.times.push(occurrence.time);
                points.states.extend_from_slice(occurrence.momentum.as_slice());
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
    fn keep(&self, sample: &Sample, record: &mut Record) {
        let (momentum, before) = (sample.momentum.as_slice(), record.values.len());
        self.conserved.append(sample.time, momentum, &mut record.values);
        if record.values.iter().skip(before).any(|value| !value.is_finite()) {
            let reason = self.conserved.without_value(sample.time, momentum);
            let text = format!("at t = {}: {reason}", sample.time);
            record.failure = Some(IntegrationError::new_err(text));
            if before > 0 {
                record.values.truncate(before);
                return;
            }
        }
        record.samples.times.push(sample.time);
        record.samples.states.extend_from_slice(momentum);
        if let Some(attitude) = sample.state.as_slice().last_chunk::<4>().filter(|_| self.attitude)
        {
            record.attitudes.extend_from_slice(attitude);
        }
    }
}
