//! Statistics of many paths of a motion with noise, as Python sees them.

use super::many::AnySystem;
use super::open::ModelOfRun;
use crate::arrays::rows;
use crate::errors::{failed, refused};
use crate::runs::following::Setting;
use crate::runs::interruption::until_interrupted;
use core::sync::atomic::Ordering;
use heavytop::methods::Method;
use lie_poisson_runs::{
    Experiment, Model, Pace, PathEnsemble, PathRow, PathStatistics, RunFailure, Schedule,
};
use numpy::PyArray2;
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::{Bound, PyResult, Python, pyfunction};

/// The end, the number of steps between two records, and the number of paths.
type Extent = (f64, u64, u64);

/// The times, and for each of them the numbers of each coordinate and each conserved quantity: the mean, its error, the deviation,
/// and the quantiles.
type StatisticsArrays<'py> = (Vec<f64>, Bound<'py, PyArray2<f64>>);

/// Follows many paths from one start, and returns their statistics.
#[pyfunction]
pub fn statistics_of_paths<'py>(
    py: Python<'py>,
    system: AnySystem<'py>,
    setting: Setting,
    extent: Extent,
    quantiles: Vec<f64>,
) -> PyResult<StatisticsArrays<'py>> {
    let ((start, step, method), (end, every, paths)) = (setting, extent);
    let (method, model) = (system.method(method)?, system.model(step)?);
    model.require_until(end)?;
    let start = model.start(&start).map_err(refused)?;
    model.conserved(&start).values(0.0, &start).map_err(PyValueError::new_err)?;
    let pace = Pace { schedule: Schedule::new(step, end).map_err(refused)?, every };
    let run = experiment(model, (start, method, pace));
    let ensemble = PathEnsemble { paths, quantiles };
    let found =
        until_interrupted(py, |stop| ensemble.follow(&run, |_| !stop.load(Ordering::Relaxed)))?;
    let found = found.map_err(|error| match error {
        RunFailure::Path { .. } => failed(error),
        _ => refused(error),
    })?;
    let found = found.ok_or_else(|| PyKeyboardInterrupt::new_err(()))?;
    let times: Vec<f64> = found.iter().map(|row| row.time).collect();
    let shape = [found.len(), found.first().map_or(0, |row| numbers(row).count())];
    let all = rows(py, found.iter().flat_map(numbers).collect(), shape)?;
    Ok((times, all))
}

/// Returns the run of a model.
fn experiment(model: ModelOfRun<'_>, run: (Vec<f64>, Method, Pace)) -> Box<Experiment> {
    match model {
        ModelOfRun::Closed(system) => of_model(system.clone(), run),
        ModelOfRun::Open(open) => of_model(*open, run),
        ModelOfRun::Arrays(arrays) => of_model(arrays.clone(), run),
        ModelOfRun::OpenArrays(arrays) => of_model(*arrays, run),
    }
}

fn of_model<M: Model + 'static>(
    model: M,
    (start, method, pace): (Vec<f64>, Method, Pace),
) -> Box<Experiment> {
    Box::new(Experiment { start, method, pace, attitude: false, model })
}

/// Returns the numbers of a row.
fn numbers(row: &PathRow) -> impl Iterator<Item = f64> {
    let of = |PathStatistics { mean, error, deviation, quantiles }: &PathStatistics| {
        [*mean, *error, *deviation].into_iter().chain(quantiles.clone())
    };
    row.quantities.iter().flat_map(of)
}
