//! Indicators of chaos of many runs, as Python sees them.

use crate::errors::{message, refused};
use crate::runs::growth::{Growth, GrowthTask};
use crate::runs::interruption::until_interrupted;
use core::sync::atomic::Ordering;
use heavytop::methods::Method;
use lie_poisson_formula_systems::{OpenSystem, OpenSystemError};
use lie_poisson_runs::{Model, Schedule};
use pyo3::{PyResult, Python, pyclass};
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

/// The step, the end, and the number of steps between two records; 0 records the end alone.
pub(crate) type Times = (f64, f64, u64);

/// Follows tangent vectors along the run of each start, which is one of its own model or of the only one, on all threads: for
/// so many exponents, or for SALI.
///
/// # Errors
/// Returns `ValueError` if a model cannot have its start, the steps are none, or there are no such tangent vectors, and
/// `KeyboardInterrupt`.
pub(crate) fn growth_of_models(
    py: Python<'_>,
    models: &[&dyn Model],
    starts: &[Vec<f64>],
    (step, end, every): Times,
    (method, exponents): (&Method, Option<usize>),
) -> PyResult<Indicators> {
    let of = |index: usize| models.get(index).or(models.first());
    let start = |(index, given): (usize, &Vec<f64>)| match of(index) {
        Some(model) => model.start(given).map_err(refused),
        None => Ok(given.clone()),
    };
    let starts: Vec<Vec<f64>> = starts.iter().enumerate().map(start).collect::<PyResult<_>>()?;
    let schedule = Schedule::new(step, end).map_err(refused)?;
    let runs = until_interrupted(py, |stop| {
        let one = |(index, start): (usize, &Vec<f64>)| {
            if stop.load(Ordering::Relaxed) {
                return Err("interrupted".into());
            }
            let model = *of(index).ok_or("there is no system")?;
            let integrator = model.tangent_integrator(method, start);
            let integrator = integrator.map_err(|error| message(&error))?;
            let (member, noise) = (index as u64, model.noise());
            if let Some((_, first)) = noise
                && first.saturating_add(member) >= OpenSystem::PATHS
            {
                let (path, most) = (first.saturating_add(member), OpenSystem::PATHS);
                return Err(message(&OpenSystemError::PathNumber { path, most }));
            }
            let on_path = |state: &mut [f64]| model.move_path(state, member);
            let task = GrowthTask { start, schedule, every, stop, exponents, on_path: &on_path };
            let mut grown = task.grow(&integrator)?;
            model.present(&mut grown.end);
            Ok(grown)
        };
        starts.par_iter().enumerate().map(one).collect::<Vec<_>>()
    })?;
    Ok(Indicators::new(runs))
}

/// The indicators of chaos of many runs. A run that failed has no numbers.
#[pyclass(frozen, get_all, module = "heavytop._native")]
pub struct Indicators {
    /// The times of the records.
    times: Vec<f64>,
    /// For each run, the exponents at each time.
    exponents: Vec<Vec<f64>>,
    /// For each run, MEGNO at each time.
    megno: Vec<Vec<f64>>,
    /// For each run, SALI at each time, if it was asked for.
    sali: Vec<Vec<f64>>,
    /// For each run, the state at the end.
    ends: Vec<Vec<f64>>,
    /// The index and the message of each run that failed.
    failures: Vec<(usize, String)>,
}

impl Indicators {
    /// Creates the columns of the growth of tangent vectors in many runs.
    fn new(runs: Vec<Result<Growth, String>>) -> Self {
        let mut all = Self {
            times: Vec::new(),
            exponents: Vec::new(),
            megno: Vec::new(),
            sali: Vec::new(),
            ends: Vec::new(),
            failures: Vec::new(),
        };
        for (index, run) in runs.into_iter().enumerate() {
            let growth = run.unwrap_or_else(|message| {
                all.failures.push((index, message));
                Growth::default()
            });
            if !growth.times.is_empty() {
                all.times = growth.times;
            }
            all.exponents.push(growth.exponents);
            all.megno.push(growth.megno);
            all.sali.push(growth.sali);
            all.ends.push(growth.end);
        }
        all
    }
}
