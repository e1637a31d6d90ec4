//! Indicators of chaos for many runs of tops, on all threads.

use super::top::{MethodNames, Top, made};
use crate::arrays::{numbers, read_rows};
use crate::errors::message;
use crate::recorded::Indicators;
use crate::runs::growth::{GrowthTask, Tangents};
use crate::runs::interruption::until_interrupted;
use crate::runs::schedule::{Schedule, steps};
use core::sync::atomic::Ordering;
use numpy::PyReadonlyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::{PyRef, PyResult, Python, pyfunction};
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

/// The step, the end, and the number of steps between two records; 0 records the end alone.
type Times = (f64, f64, u64);

/// Follows tangent vectors along the run of each state, with its own top or the only one.
#[pyfunction]
pub fn growth_of_tops(
    py: Python<'_>,
    tops: Vec<PyRef<'_, Top>>,
    states: PyReadonlyArray2<'_, f64>,
    times: Times,
    method: MethodNames,
    tangents: &str,
) -> PyResult<Indicators> {
    let states: Vec<[f64; 6]> = read_rows("the states", &states)?;
    let tops: Vec<Top> = tops.iter().map(|top| **top).collect();
    if tops.len() != 1 && tops.len() != states.len() {
        let text = format!("there are {} tops and {} states", tops.len(), states.len());
        return Err(PyValueError::new_err(text));
    }
    let of = |index: usize| tops.get(index).or(tops.first());
    let principal = |(index, given): (usize, &[f64; 6])| match of(index) {
        Some(top) => top.principal(*given).map(|mu| numbers(&mu)),
        None => Ok(*given),
    };
    let states: Vec<[f64; 6]> =
        states.iter().enumerate().map(principal).collect::<PyResult<_>>()?;
    let ((step, end, every), method) = (times, made(method)?);
    let (steps, tangents) = (steps(step, end)?, tangents_named(tangents)?);
    let runs = until_interrupted(py, |stop| {
        let one = |(index, start): (usize, &[f64; 6])| {
            if stop.load(Ordering::Relaxed) {
                return Err("interrupted".into());
            }
            let schedule = Schedule { start: start.to_vec(), step, steps };
            let task = GrowthTask { schedule: &schedule, every, stop, tangents };
            let top = of(index).ok_or("there is no top")?;
            let integrator =
                method.tangent_integrator(&top.top).map_err(|error| message(&error))?;
            let mut grown = task.grow(&integrator)?;
            top.give(&mut grown.end);
            Ok(grown)
        };
        states.par_iter().enumerate().map(one).collect::<Vec<_>>()
    })?;
    Ok(Indicators::new(runs))
}

/// Returns the tangent vectors of a name.
pub(crate) fn tangents_named(name: &str) -> PyResult<Tangents> {
    match name {
        "one" => Ok(Tangents::One),
        "two" => Ok(Tangents::Two),
        "all" => Ok(Tangents::All),
        other => Err(PyValueError::new_err(format!("tangents are one, two or all, got {other}"))),
    }
}
