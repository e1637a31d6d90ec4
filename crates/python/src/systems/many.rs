//! Many states of one system at once, on all threads.

use super::system::{MethodArgument, System};
use super::tasks::{End, Ends};
use crate::arrays::rows;
use crate::errors::message;
use crate::recorded::Indicators;
use crate::runs::growth::GrowthTask;
use crate::runs::interruption::until_interrupted;
use crate::runs::schedule::{Schedule, steps};
use crate::tops::chaos::tangents_named;
use core::sync::atomic::Ordering;
use heavytop::methods::Formulation;
use lie_poisson_formula_systems::SystemMethod;
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::{Bound, PyRef, PyResult, Python, pyfunction};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
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
    let (method, steps, system) = (system.method(method)?, steps(step, end)?, &system.system);
    let starts: Vec<Vec<f64>> = states.as_array().outer_iter().map(|row| row.to_vec()).collect();
    // Which Clebsch map an integrator has depends on the start.
    let is_clebsch = method.formulation() == Formulation::Collective
        && SystemMethod::default_formulation(system.algebra()) != Formulation::Collective;
    let shared = if is_clebsch { 1 } else { SHARED };
    let ends: Vec<Vec<End>> = until_interrupted(py, |stop| {
        let some = |starts: &[Vec<f64>]| {
            let task = Ends { system, starts, step, steps, stop };
            let first = starts.first().map(Vec::as_slice).unwrap_or_default();
            method.integrate(system, first, task).unwrap_or_else(|error| {
                let failed = |start: &Vec<f64>| (start.clone(), Some(message(&error)));
                starts.iter().map(failed).collect()
            })
        };
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

/// Follows tangent vectors along the run of each state.
#[pyfunction]
pub fn growth_of_system(
    py: Python<'_>,
    system: PyRef<'_, System>,
    states: PyReadonlyArray2<'_, f64>,
    times: (f64, f64, u64),
    method: MethodArgument,
    tangents: &str,
) -> PyResult<Indicators> {
    let ((step, end, every), method) = (times, system.method(method)?);
    let (steps, tangents, system) = (steps(step, end)?, tangents_named(tangents)?, &system.system);
    let starts: Vec<Vec<f64>> = states.as_array().outer_iter().map(|row| row.to_vec()).collect();
    let runs = until_interrupted(py, |stop| {
        let one = |start: &Vec<f64>| {
            if stop.load(Ordering::Relaxed) {
                return Err("interrupted".into());
            }
            let schedule = Schedule { start: start.clone(), step, steps };
            let task = GrowthTask { schedule: &schedule, every, stop, tangents };
            method.integrate(system, start, task).unwrap_or_else(|error| Err(message(&error)))
        };
        starts.par_iter().map(one).collect::<Vec<_>>()
    })?;
    Ok(Indicators::new(runs))
}
