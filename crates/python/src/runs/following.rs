//! What is done along one run of any system: [`Following`].

use super::accuracy::{Accuracy, Check, accuracy, check};
use super::dense::states_at;
use super::event::Event;
use super::interruption::Interruption;
use super::record::Record;
use super::recording::Recording;
use crate::arrays::rows;
use crate::errors::{failed, refused};
use collective_integrators::diagnostics::Balance;
use collective_integrators::{AnyState, Integrator, Start};
use heavytop::methods::Method;
use lie_poisson::Quaternion;
use lie_poisson_runs::{Model, RunFailure, Schedule};
use numpy::PyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::{Bound, PyResult, Python};

/// A formulation, which may be left to the system, a scheme, and the tolerance of its stage equations.
pub(crate) type MethodArgument = (Option<String>, String, f64);

/// The change of a conserved quantity, what the forces supplied of it, and the largest difference of both.
pub(crate) type BalanceNumbers = (f64, f64, f64);

/// The start, the step and the method of a run.
pub(crate) type Setting = (Vec<f64>, f64, MethodArgument);

/// A system, its start in the axes of the computation, a method and a step.
pub(crate) struct Following<'a> {
    model: &'a dyn Model,
    method: Method,
    start: Vec<f64>,
    step: f64,
}

impl<'a> Following<'a> {
    /// Creates it from a start in the axes of the users.
    ///
    /// # Errors
    /// Returns `ValueError` if the system cannot have this start.
    pub(crate) fn new(
        model: &'a dyn Model,
        method: Method,
        (given, step): (&[f64], f64),
    ) -> PyResult<Self> {
        let start = model.start(given).map_err(refused)?;
        Ok(Self { model, method, start, step })
    }

    /// Records every n-th sample to the end, and events. With `attitude`, it is recorded too, from this one or, without
    /// one, from the shortest rotation of Γ to the vertical.
    ///
    /// # Errors
    /// Returns `ValueError` if there is no such run, and `KeyboardInterrupt`.
    pub(crate) fn record(
        &self,
        py: Python<'_>,
        (end, every): (f64, u64),
        events: &[Event<'_>],
        attitude: Option<Option<Quaternion>>,
    ) -> PyResult<(Record, [usize; 2])> {
        let schedule = Schedule::new(self.step, end).map_err(refused)?;
        if every == 0 {
            return Err(PyValueError::new_err("every must be at least 1, got 0"));
        }
        let conserved = &*self.model.conserved(&self.start);
        let widths = [self.start.len(), conserved.names().len()];
        let has_attitude = attitude.is_some();
        let recording =
            Recording { schedule, every, conserved, events, widths, attitude: has_attitude };
        let record = py.detach(|| {
            let integrator = match attitude {
                Some(_) => self.model.integrator_with_attitude(&self.method, &self.start),
                None => self.model.integrator(&self.method, &self.start),
            };
            let (integrator, start) =
                (integrator.map_err(refused)?, AnyState::from_slice(&self.start));
            let Some(attitude) = attitude.flatten() else {
                let run = integrator.trajectory(&start, self.step).map_err(refused)?;
                return recording.follow(&integrator, run);
            };
            let mut state = integrator.start(&start).map_err(refused)?;
            if let Some(last) = state.as_mut_slice().last_chunk_mut::<4>() {
                let Quaternion { scalar, vector } = attitude;
                *last = [scalar, vector.x, vector.y, vector.z];
            }
            let run = integrator.trajectory_from(state, self.step).through(start);
            recording.follow(&integrator, run)
        })?;
        Ok((record, widths))
    }

    /// Measures how accurate a run of so many steps is: the angle of a step (rad), the estimated error, and a warning.
    ///
    /// # Errors
    /// Returns `ValueError` if there is no such run, and `KeyboardInterrupt`.
    pub(crate) fn accuracy(&self, py: Python<'_>, steps: u64) -> PyResult<Accuracy> {
        py.detach(|| {
            let interruption = Interruption::default();
            let going = || interruption.is_going();
            let measured =
                self.model.accuracy(&self.method, &self.start, (self.step, steps), &going);
            interruption.or(measured
                .map(|measured| accuracy(self.model, &self.start, measured))
                .map_err(refused))
        })
    }

    /// Checks a run of so many steps by half the step and twice the step, and returns the error and the order.
    ///
    /// # Errors
    /// Returns `ValueError` if there is no such run, `IntegrationError` if a step fails, and `KeyboardInterrupt`.
    pub(crate) fn check(&self, py: Python<'_>, steps: u64) -> PyResult<Check> {
        py.detach(|| {
            let interruption = Interruption::default();
            let going = || interruption.is_going();
            let checked = self.model.check(&self.method, &self.start, (self.step, steps), &going);
            interruption.or(checked.map_err(refused).and_then(check))
        })
    }

    /// Measures the balances of a run of so many steps: the change, what the forces supplied, and the largest difference of both, of
    /// each conserved quantity in their order.
    ///
    /// # Errors
    /// Returns `ValueError` if the forces have no rates, `IntegrationError` if a step fails, and `KeyboardInterrupt`.
    pub(crate) fn balances(&self, py: Python<'_>, steps: u64) -> PyResult<Vec<BalanceNumbers>> {
        py.detach(|| {
            let interruption = Interruption::default();
            let going = || interruption.is_going();
            let found =
                self.model.balances((&self.method, &self.start), (self.step, steps), &going);
            let found = found.map_err(|error| match error {
                RunFailure::Integration { .. } | RunFailure::NoValue { .. } => failed(error),
                _ => refused(error),
            });
            let numbers = |(_, of): (String, Balance)| (of.change, of.supplied, of.defect);
            let found = found.map(|found| found.into_iter().flatten().map(numbers).collect());
            interruption.or(found)
        })
    }

    /// Returns the states at times in the order of the run, as rows.
    ///
    /// # Errors
    /// Returns `ValueError` for times that are not in order, `IntegrationError` if a step fails, and `KeyboardInterrupt`.
    pub(crate) fn states_at<'py>(
        &self,
        py: Python<'py>,
        times: &[f64],
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let mut states = py.detach(|| {
            let integrator = self.model.integrator(&self.method, &self.start).map_err(refused)?;
            states_at(&integrator, (&self.start, self.step), times)
        })?;
        present(self.model, &mut states, self.start.len());
        rows(py, states, [times.len(), self.start.len()])
    }
}

/// Replaces states of a dimension, one after the other, by those in the axes of the users.
pub(crate) fn present(model: &dyn Model, states: &mut [f64], dimension: usize) {
    states.chunks_mut(dimension.max(1)).for_each(|state| model.present(state));
}
