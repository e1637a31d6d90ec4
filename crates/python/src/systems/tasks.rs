//! Tasks along a run, for the integrators of systems.

use crate::errors::{message, refused};
use crate::runs::record::Record;
use crate::runs::recording::{Quantities, Recording};
use crate::runs::schedule::{MOST_DIMENSIONS, Schedule, coordinates};
use collective_integrators::{CHECKPOINT, Start, TangentIntegrator};
use core::sync::atomic::{AtomicBool, Ordering};
use lie_poisson::Vector;
use lie_poisson_formula_systems::{FormulaSystem, SystemTask};
use pyo3::PyResult;

/// The Hamiltonian and the Casimirs of a system.
pub(super) struct Invariants<'a>(pub(super) &'a FormulaSystem);

impl Quantities for Invariants<'_> {
    fn count(&self) -> usize {
        1 + self.0.casimirs().len()
    }

    fn append<M: Vector<Scalar = f64>>(&self, mu: &M, values: &mut Vec<f64>) {
        let mut all = [0.0; MOST_DIMENSIONS];
        let state = coordinates(mu, &mut all, self.0.algebra().dimension());
        values.push(self.0.hamiltonian().value_at(state));
        values.extend(self.0.casimirs().iter().map(|casimir| casimir.value_at(state)));
    }
}

/// The task of recording a run of a system.
pub(super) struct RecordSystem<'a>(pub(super) Recording<'a, Invariants<'a>>);

impl SystemTask for RecordSystem<'_> {
    type Output = PyResult<Record>;

    fn perform<I>(self, integrator: &I) -> Self::Output
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>> + TangentIntegrator,
    {
        let Schedule { step, .. } = *self.0.schedule;
        let start = self.0.schedule.start();
        let run = Start::<f64>::trajectory(integrator, &start, step).map_err(refused)?;
        let system = self.0.quantities.0;
        let record = self.0.follow(integrator, run, |_| None)?;
        // The numbers of a sample that are not finite have a reason, which names the formula and the state.
        let widths = (system.algebra().dimension(), self.0.quantities.count());
        let samples = record.samples.states.chunks(widths.0).zip(record.values.chunks(widths.1));
        for (state, values) in samples {
            if values.iter().any(|value| !value.is_finite()) {
                system.invariants(state).map_err(refused)?;
            }
        }
        Ok(record)
    }
}

/// The end of a run, or the last state and the reason why the next step fails.
pub(super) type End = (Vec<f64>, Option<String>);

/// The task of following several starts to the end, one after the other.
pub(super) struct Ends<'a> {
    pub(super) starts: &'a [Vec<f64>],
    pub(super) step: f64,
    pub(super) steps: u64,
    /// Set by others if the task is to end.
    pub(super) stop: &'a AtomicBool,
}

impl SystemTask for Ends<'_> {
    type Output = Vec<End>;

    fn perform<I>(self, integrator: &I) -> Self::Output
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>> + TangentIntegrator,
    {
        self.starts.iter().map(|start| self.end(integrator, start)).collect()
    }
}

impl Ends<'_> {
    fn end<I>(&self, integrator: &I, start: &[f64]) -> End
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        let schedule = Schedule { start: start.to_vec(), step: self.step, steps: self.steps };
        let mut run = match integrator.trajectory(&schedule.start(), self.step) {
            Ok(run) => run,
            Err(error) => return (schedule.start, Some(message(&error))),
        };
        let mut last = start.to_vec();
        // The first sample is the start.
        run.next();
        for made in 1..=self.steps {
            match run.next() {
                Some(Ok(sample)) => {
                    last.clear();
                    last.extend(schedule.coordinates(&sample.momentum));
                }
                Some(Err(error)) => return (last, Some(message(&error))),
                None => break,
            }
            if made.is_multiple_of(CHECKPOINT) && self.stop.load(Ordering::Relaxed) {
                break;
            }
        }
        (last, None)
    }
}
