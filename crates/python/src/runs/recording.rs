//! The task of recording a run: times, states, attitudes.

use crate::arrays::numbers;
use crate::errors::{failed, refused};
use collective_integrators::{Sample, Start};
use heavytop::methods::Task;
use heavytop::{Turning, WithAttitude};
use lie_poisson::{Quaternion, Se3Dual, Vector};
use pyo3::exceptions::PyValueError;
use pyo3::{PyErr, PyResult, Python};

/// The number of steps after which a run looks for Ctrl-C.
const BETWEEN_SIGNALS: u64 = 1 << 16;

/// What is recorded of a run.
#[derive(Default)]
pub(crate) struct Record {
    /// The times of the samples.
    pub(crate) times: Vec<f64>,
    /// The states (Π, Γ) of the samples, six numbers each.
    pub(crate) states: Vec<f64>,
    /// The attitude quaternions, four numbers each.
    pub(crate) attitudes: Vec<f64>,
    /// The number of iterations of all steps.
    pub(crate) iterations: u64,
    /// The error that ended the run, if any.
    pub(crate) failure: Option<PyErr>,
}

/// The task of recording every n-th sample of a run, and the last one.
pub(crate) struct Recording {
    pub(crate) start: Se3Dual,
    pub(crate) step: f64,
    pub(crate) steps: u64,
    pub(crate) every: u64,
    pub(crate) attitude: bool,
}

impl Recording {
    fn follow<I: Start<State: Vector, Momentum = Se3Dual>>(
        &self,
        integrator: &I,
        attitude: impl Fn(&I::State) -> Option<&Quaternion>,
    ) -> PyResult<Record> {
        let rows = (self.steps / self.every) as usize + 2;
        let mut record = Record::default();
        record.times.reserve(rows);
        record.states.reserve(6 * rows);
        for sample in integrator.trajectory(&self.start, self.step).map_err(refused)? {
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
            if sample.step.is_multiple_of(BETWEEN_SIGNALS) {
                Python::attach(|py| py.check_signals())?;
            }
        }
        Ok(record)
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
        if let Some(Quaternion { scalar, vector }) = attitude {
            record.attitudes.extend([*scalar, vector.x, vector.y, vector.z]);
        }
    }
}

impl Task for Recording {
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
