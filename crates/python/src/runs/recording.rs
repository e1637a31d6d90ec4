//! The task of recording a run: times, states, conserved quantities, attitudes.

use crate::arrays::numbers;
use crate::errors::{failed, refused};
use crate::runs::interruption::Interruption;
use collective_integrators::{IntegrationError, Sample, Start};
use heavytop::methods::Task;
use heavytop::{HeavyTop, Invariant, Turning, WithAttitude};
use lie_poisson::{Quaternion, Se3Dual, Vector};
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::{PyErr, PyResult};

/// What is recorded of a run.
#[derive(Default)]
pub(crate) struct Record {
    /// The times of the samples.
    pub(crate) times: Vec<f64>,
    /// The states (Π, Γ) of the samples, six numbers each.
    pub(crate) states: Vec<f64>,
    /// The conserved quantities, as many numbers each as the top has.
    pub(crate) invariants: Vec<f64>,
    /// The attitude quaternions, four numbers each.
    pub(crate) attitudes: Vec<f64>,
    /// The number of iterations of all steps.
    pub(crate) iterations: u64,
    /// The error that ended the run, if any.
    pub(crate) failure: Option<PyErr>,
}

impl Record {
    /// Creates an empty record with room for all samples.
    fn new(samples: u64, invariants: usize, attitude: bool) -> PyResult<Self> {
        let mut record = Self::default();
        let Self { times, states, invariants: values, attitudes, .. } = &mut record;
        let width = if attitude { 4 } else { 0 };
        let columns = [(times, 1), (states, 6), (values, invariants), (attitudes, width)];
        let bytes: usize = columns.iter().map(|(_, width)| 8 * width).sum();
        for (column, width) in columns {
            let count =
                usize::try_from(samples).ok().and_then(|samples| samples.checked_mul(width));
            let room = count.is_some_and(|count| column.try_reserve_exact(count).is_ok());
            if !room {
                return Err(PyMemoryError::new_err(format!(
                    "{samples} samples of {bytes} bytes do not fit into memory; keep fewer with `every`"
                )));
            }
        }
        Ok(record)
    }
}

/// The task of recording every n-th sample of a run, and the last one.
pub(crate) struct Recording<'a> {
    pub(crate) top: &'a HeavyTop,
    pub(crate) invariants: &'a [Invariant],
    pub(crate) start: Se3Dual,
    pub(crate) step: f64,
    pub(crate) steps: u64,
    pub(crate) every: u64,
    pub(crate) attitude: bool,
}

impl Recording<'_> {
    fn follow<I: Start<State: Vector, Momentum = Se3Dual>>(
        &self,
        integrator: &I,
        attitude: impl Fn(&I::State) -> Option<&Quaternion>,
    ) -> PyResult<Record> {
        let samples = (self.steps / self.every).saturating_add(2);
        let record = Record::new(samples, self.invariants.len(), self.attitude)?;
        let run = integrator.trajectory(&self.start, self.step).map_err(refused)?;
        let interruption = Interruption::default();
        let record = self.record(interruption.until(run), record, attitude);
        interruption.or(Ok(record))
    }

    fn record<S>(
        &self,
        run: impl Iterator<Item = Result<Sample<S, Se3Dual>, IntegrationError>>,
        mut record: Record,
        attitude: impl Fn(&S) -> Option<&Quaternion>,
    ) -> Record {
        for sample in run {
            let sample = match sample {
                Ok(sample) => sample,
                Err(error) => {
                    record.failure = Some(failed(error));
                    break;
                }
            };
            record.iterations += sample.iterations as u64;
            if sample.step.is_multiple_of(self.every) || sample.step >= self.steps {
                self.keep(&sample, attitude(&sample.state), &mut record);
            }
            if sample.step >= self.steps {
                break;
            }
        }
        record
    }

    fn keep<S>(
        &self,
        sample: &Sample<S, Se3Dual>,
        attitude: Option<&Quaternion>,
        record: &mut Record,
    ) {
        // M of the lift of the start equals the start only up to rounding; the start itself is reported.
        let momentum = if sample.step == 0 { &self.start } else { &sample.momentum };
        record.times.push(sample.time);
        record.states.extend(numbers(momentum));
        let values = self.invariants.iter().map(|invariant| invariant.value(self.top, momentum));
        record.invariants.extend(values);
        if let Some(Quaternion { scalar, vector }) = attitude {
            record.attitudes.extend([*scalar, vector.x, vector.y, vector.z]);
        }
    }
}

impl Task for Recording<'_> {
    type Output = PyResult<Record>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(
        self,
        integrator: &I,
    ) -> PyResult<Record> {
        if self.attitude {
            return Err(PyValueError::new_err(
                "direct has no attitude: its six equations do not determine it; collective, reduced and \
                 splitting have one",
            ));
        }
        self.follow(integrator, |_| None)
    }

    fn perform_turning<I: Turning + Start>(self, integrator: I) -> PyResult<Record> {
        if self.attitude {
            self.follow(&WithAttitude(integrator), |state| Some(&state.1))
        } else {
            self.follow(&integrator, |_| None)
        }
    }
}
