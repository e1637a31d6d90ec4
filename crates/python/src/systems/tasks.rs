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

    /// Names the formula, its part without a value, and the state.
    fn without_value<M: Vector<Scalar = f64>>(&self, mu: &M) -> String {
        let mut all = [0.0; MOST_DIMENSIONS];
        let values = self.0.invariants(coordinates(mu, &mut all, self.0.algebra().dimension()));
        values.map_or_else(|error| message(&error), |_| "an invariant is not finite".into())
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
        let Schedule { start, step, .. } = self.0.schedule;
        self.0.quantities.0.invariants(start).map_err(refused)?;
        let start = self.0.schedule.start();
        let run = Start::<f64>::trajectory(integrator, &start, *step).map_err(refused)?;
        self.0.follow(integrator, run, |_| None)
    }
}

/// The end of a run, or the last state and the reason why the next step fails.
pub(super) type End = (Vec<f64>, Option<String>);

/// The task of following several starts to the end, one after the other.
pub(super) struct Ends<'a> {
    pub(super) system: &'a FormulaSystem,
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
        let reason = self.system.invariants(&last).err();
        (last, reason.map(|error| message(&error)))
    }
}
