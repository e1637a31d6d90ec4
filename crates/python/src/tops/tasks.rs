//! Tasks along a run, for the integrators of tops.

use crate::errors::refused;
use crate::runs::record::Record;
use crate::runs::recording::{Quantities, Recording};
use crate::runs::schedule::Schedule;
use collective_integrators::{Integrator, Start};
use heavytop::methods::Task;
use heavytop::{HeavyTop, Invariant, Turning, WithAttitude};
use lie_poisson::{Pair, Quaternion, Se3Dual, Vector};
use pyo3::PyResult;
use pyo3::exceptions::PyValueError;

/// The invariants of a top.
pub(super) struct Invariants<'a> {
    pub(super) top: &'a HeavyTop,
    pub(super) list: &'a [Invariant],
}

impl Quantities for Invariants<'_> {
    fn count(&self) -> usize {
        self.list.len()
    }

    fn append<M: Vector<Scalar = f64>>(&self, mu: &M, values: &mut Vec<f64>) {
        let mu: Se3Dual = Vector::from_coordinates(|i| mu.coordinate(i));
        values.extend(self.list.iter().map(|invariant| invariant.value(self.top, &mu)));
    }

    fn without_value<M: Vector<Scalar = f64>>(&self, mu: &M) -> String {
        let mu: Se3Dual = Vector::from_coordinates(|i| mu.coordinate(i));
        let is_infinite = |i: &&Invariant| !i.value(self.top, &mu).is_finite();
        let symbol = self.list.iter().find(is_infinite).map_or("h", |i| i.symbol());
        format!("the invariant {symbol} is not finite")
    }
}

/// The task of recording a run of a top.
pub(super) struct RecordTop<'a> {
    pub(super) recording: Recording<'a, Invariants<'a>>,
    /// The attitude at the start; `None` for the shortest rotation of Γ to the vertical.
    pub(super) initial_attitude: Option<Quaternion>,
}

impl Task for RecordTop<'_> {
    type Output = PyResult<Record>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(
        self,
        integrator: &I,
    ) -> PyResult<Record> {
        if self.recording.attitude {
            return Err(PyValueError::new_err(
                "direct has no attitude: its six equations do not determine it; collective, reduced and \
                 splitting have one",
            ));
        }
        let Schedule { step, .. } = *self.recording.schedule;
        let start = self.recording.schedule.start();
        let run = integrator.trajectory(&start, step).map_err(refused)?;
        self.recording.follow(integrator, run, |_| None)
    }

    fn perform_turning<I: Turning + Start>(self, integrator: I) -> PyResult<Record> {
        if !self.recording.attitude {
            return self.perform(&integrator);
        }
        let integrator = WithAttitude(integrator);
        let start = self.recording.schedule.start();
        let Pair(state, shortest) = integrator.start(&start).map_err(refused)?;
        let attitude = self.initial_attitude.unwrap_or(shortest);
        let run = integrator.trajectory_from(Pair(state, attitude), self.recording.schedule.step);
        let run = run.through(start);
        self.recording.follow(&integrator, run, |state| Some(&state.1))
    }
}
