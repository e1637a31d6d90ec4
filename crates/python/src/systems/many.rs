//! Many states of one system at once, on all threads.

use super::arrays::Arrays;
use super::open::ModelOfRun;
use super::system::System;
use crate::arrays::rows;
use crate::errors::{message, refused};
use crate::indicators::{Indicators, Times, growth_of_models};
use crate::runs::following::MethodArgument;
use crate::runs::interruption::until_interrupted;
use collective_integrators::{AnyIntegrator, AnyState, CHECKPOINT, Integrator, Start};
use core::sync::atomic::{AtomicBool, Ordering};
use heavytop::methods::Method;
use lie_poisson_formula_systems::{OpenSystem, OpenSystemError};
use lie_poisson_runs::{Model, RunFailure, Schedule};
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::{Bound, FromPyObject, PyRef, PyResult, Python, pyfunction};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSlice;

/// The largest number of runs that share an integrator, and the number of such groups for each thread, if there are enough runs.
const SHARED: usize = 64;
const GROUPS: usize = 4;

/// A system by formula, or one of arrays.
#[derive(FromPyObject)]
pub enum AnySystem<'py> {
    /// A system by formula.
    Formula(PyRef<'py, System>),
    /// A system of arrays.
    Arrays(PyRef<'py, Arrays>),
}

impl AnySystem<'_> {
    /// Returns the model of runs with steps of a size and without events.
    pub(crate) fn model(&self, step: f64) -> PyResult<ModelOfRun<'_>> {
        match self {
            Self::Formula(system) => {
                system.require_named_inputs(&[])?;
                system.model(step)
            }
            Self::Arrays(arrays) => arrays.model(step),
        }
    }

    /// Returns the method of these names.
    pub(crate) fn method(&self, method: MethodArgument) -> PyResult<Method> {
        match self {
            Self::Formula(system) => system.method(method),
            Self::Arrays(arrays) => arrays.method(method),
        }
    }
}

/// The states at the end, and the index and the message of each run that failed.
type EndArrays<'py> = (Bound<'py, PyArray2<f64>>, Vec<(u64, String)>);

/// Advances many states of a system to the end.
#[pyfunction]
pub fn advance_system<'py>(
    py: Python<'py>,
    system: AnySystem<'py>,
    states: PyReadonlyArray2<'py, f64>,
    step: f64,
    end: f64,
    method: MethodArgument,
) -> PyResult<EndArrays<'py>> {
    let (method, model) = (system.method(method)?, system.model(step)?);
    model.require_until(end)?;
    let model = &*model;
    let members = states.as_array().nrows() as u64;
    if let Some((_, first)) = model.noise()
        && first.saturating_add(members) > OpenSystem::PATHS
    {
        let (path, most) = (first.saturating_add(members), OpenSystem::PATHS);
        return Err(refused(OpenSystemError::PathNumber { path, most }));
    }
    let steps = Schedule::new(step, end).map_err(refused)?.steps;
    let starts = states.as_array();
    let starts = starts.outer_iter().map(|row| model.start(&row.to_vec()).map_err(refused));
    let starts: Vec<Vec<f64>> = starts.collect::<PyResult<_>>()?;
    let shared = starts.len().div_ceil(GROUPS * rayon::current_num_threads()).clamp(1, SHARED);
    let ends: Vec<Vec<End>> = until_interrupted(py, |stop| {
        let some = |(chunk, starts): (usize, &[Vec<f64>])| {
            let first = chunk * shared;
            Ends { model, starts, first, step, steps, stop }.all(&method)
        };
        starts.par_chunks(shared).enumerate().map(some).collect()
    })?;
    let ends = ends.into_iter().flatten();
    let (mut last, mut failures) = (Vec::new(), Vec::new());
    for (index, (mut state, failure)) in (0..).zip(ends) {
        model.present(&mut state);
        last.extend(state);
        failures.extend(failure.map(|message| (index, message)));
    }
    Ok((rows(py, last, [starts.len(), states.as_array().ncols()])?, failures))
}

/// The end of a run, or the last state and the reason why the next step fails.
type End = (Vec<f64>, Option<String>);

/// Several starts that are followed to the end, one after the other.
struct Ends<'a> {
    model: &'a dyn Model,
    starts: &'a [Vec<f64>],
    /// The number of the first of them among all.
    first: usize,
    step: f64,
    steps: u64,
    /// Set by others if the task is to end.
    stop: &'a AtomicBool,
}

impl Ends<'_> {
    /// Follows the starts.
    fn all(&self, method: &Method) -> Vec<End> {
        let mut shared = None;
        let follow = |(member, start): (usize, &Vec<f64>)| {
            let followed = self.follow(method, &mut shared, start, member);
            followed.unwrap_or_else(|reason| (start.clone(), Some(reason)))
        };
        (self.first..).zip(self.starts).map(follow).collect()
    }

    /// Follows a start by the shared integrator or, where that has no lift for it, by one of its own, which is shared from then on.
    fn follow(
        &self,
        method: &Method,
        shared: &mut Option<AnyIntegrator>,
        start: &[f64],
        member: usize,
    ) -> Result<End, String> {
        let from = AnyState::from_slice(start);
        if let Some(integrator) = shared.as_ref()
            && let Ok(state) = integrator.start(&from)
        {
            return Ok(self.end(integrator, state, start, member));
        }
        let own = self.model.integrator(method, start).map_err(|error| message(&error))?;
        let state = own.start(&from).map_err(|error| message(&error))?;
        Ok(self.end(shared.insert(own), state, start, member))
    }

    /// Follows the state of a start to the end.
    fn end(
        &self,
        integrator: &AnyIntegrator,
        mut state: AnyState,
        start: &[f64],
        member: usize,
    ) -> End {
        // Each member has a path of the noise of its own.
        self.model.move_path(state.as_mut_slice(), member as u64);
        let from = AnyState::from_slice(start);
        let mut run = integrator.trajectory_from(state, self.step).through(from);
        let (mut at, mut last) = (0.0, start.to_vec());
        // The first sample is the start.
        run.next();
        for made in 1..=self.steps {
            match run.next() {
                Some(Ok(sample)) => {
                    at = sample.time;
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
        let reason = self.model.conserved(start).values(at, &last).err();
        (last, reason)
    }
}

/// Follows tangent vectors along the run of each state, for so many exponents, or for SALI.
#[pyfunction]
pub fn growth_of_system(
    py: Python<'_>,
    system: AnySystem<'_>,
    states: PyReadonlyArray2<'_, f64>,
    times: Times,
    method: MethodArgument,
    exponents: Option<usize>,
) -> PyResult<Indicators> {
    let (method, model) = (system.method(method)?, system.model(times.0)?);
    model.require_until(times.1)?;
    let model = &*model;
    let starts: Vec<Vec<f64>> = states.as_array().outer_iter().map(|row| row.to_vec()).collect();
    let first = starts.first().map(Vec::as_slice).unwrap_or_default();
    if let Err(error @ (RunFailure::NoTangents { .. } | RunFailure::NoTangentsOfForces { .. })) =
        model.tangent_integrator(&method, first)
    {
        return Err(refused(error));
    }
    growth_of_models(py, &[model], &starts, times, (&method, exponents))
}
