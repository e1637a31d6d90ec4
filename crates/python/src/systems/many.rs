//! Many states of one system at once, on all threads.

use super::system::System;
use crate::arrays::rows;
use crate::errors::{message, refused};
use crate::indicators::{Indicators, Times, growth_of_models};
use crate::runs::following::MethodArgument;
use crate::runs::interruption::until_interrupted;
use collective_integrators::{AnyIntegrator, AnyState, CHECKPOINT, Start};
use core::sync::atomic::{AtomicBool, Ordering};
use heavytop::methods::{Formulation, Method};
use lie_poisson_formula_systems::FormulaSystem;
use lie_poisson_runs::{Model, Schedule};
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::{Bound, PyRef, PyResult, Python, pyfunction};
use rayon::iter::ParallelIterator;
use rayon::slice::ParallelSlice;

/// The number of runs that share an integrator.
const SHARED: usize = 64;

/// The states at the end, and the index and the message of each run that failed.
type EndArrays<'py> = (Bound<'py, PyArray2<f64>>, Vec<(u64, String)>);

/// Advances many states of a system to the end.
#[pyfunction]
pub fn advance_system<'py>(
    py: Python<'py>,
    system: PyRef<'py, System>,
    states: PyReadonlyArray2<'py, f64>,
    step: f64,
    end: f64,
    method: MethodArgument,
) -> PyResult<EndArrays<'py>> {
    let (method, system) = (system.method(method)?, &system.system);
    let steps = Schedule::new(step, end).map_err(refused)?.steps;
    let starts: Vec<Vec<f64>> = states.as_array().outer_iter().map(|row| row.to_vec()).collect();
    // Which Clebsch map an integrator has depends on the start.
    let is_clebsch = method.formulation() == Formulation::Collective
        && system.algebra().default_formulation() != Formulation::Collective;
    let shared = if is_clebsch { 1 } else { SHARED };
    let ends: Vec<Vec<End>> = until_interrupted(py, |stop| {
        let some = |starts: &[Vec<f64>]| Ends { system, starts, step, steps, stop }.all(&method);
        starts.par_chunks(shared).map(some).collect()
    })?;
    let ends = ends.into_iter().flatten();
    let (mut last, mut failures) = (Vec::new(), Vec::new());
    for (index, (state, failure)) in (0..).zip(ends) {
        last.extend(state);
        failures.extend(failure.map(|message| (index, message)));
    }
    Ok((rows(py, last, [starts.len(), system.algebra().dimension()])?, failures))
}

/// The end of a run, or the last state and the reason why the next step fails.
type End = (Vec<f64>, Option<String>);

/// Several starts that are followed to the end, one after the other.
struct Ends<'a> {
    system: &'a FormulaSystem,
    starts: &'a [Vec<f64>],
    step: f64,
    steps: u64,
    /// Set by others if the task is to end.
    stop: &'a AtomicBool,
}

impl Ends<'_> {
    /// Follows the starts by the integrator of the first.
    fn all(&self, method: &Method) -> Vec<End> {
        let first = self.starts.first().map(Vec::as_slice).unwrap_or_default();
        match self.system.tangent_integrator(method, first) {
            Ok(integrator) => {
                let integrator = integrator.without_tangents();
                self.starts.iter().map(|start| self.end(&integrator, start)).collect()
            }
            Err(error) => {
                let failed = |start: &Vec<f64>| (start.clone(), Some(message(&error)));
                self.starts.iter().map(failed).collect()
            }
        }
    }

    fn end(&self, integrator: &AnyIntegrator, start: &[f64]) -> End {
        let mut run = match integrator.trajectory(&AnyState::from_slice(start), self.step) {
            Ok(run) => run,
            Err(error) => return (start.to_vec(), Some(message(&error))),
        };
        let mut last = start.to_vec();
        // The first sample is the start.
        run.next();
        for made in 1..=self.steps {
            match run.next() {
                Some(Ok(sample)) => {
                    last.clear();
                    last.extend_from_slice(sample.momentum.as_slice());
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

/// Follows tangent vectors along the run of each state.
#[pyfunction]
pub fn growth_of_system(
    py: Python<'_>,
    system: PyRef<'_, System>,
    states: PyReadonlyArray2<'_, f64>,
    times: Times,
    method: MethodArgument,
    tangents: &str,
) -> PyResult<Indicators> {
    let (method, system): (_, &dyn Model) = (system.method(method)?, &system.system);
    let starts: Vec<Vec<f64>> = states.as_array().outer_iter().map(|row| row.to_vec()).collect();
    growth_of_models(py, &[system], &starts, times, (&method, tangents))
}
