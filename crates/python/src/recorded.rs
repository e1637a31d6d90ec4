//! The columns of runs as NumPy arrays.

use crate::arrays::rows;
use crate::runs::record::{Points, Record};
use numpy::{PyArray1, PyArray2};
use pyo3::{Py, PyErr, PyResult, Python, pyclass};

/// The times and the states of points, as rows.
type PointArrays = (Py<PyArray1<f64>>, Py<PyArray2<f64>>);

/// The columns of a run.
#[pyclass(frozen, get_all, module = "heavytop._native")]
pub struct Recorded {
    /// The times of the samples.
    times: Py<PyArray1<f64>>,
    /// The states, as rows.
    states: Py<PyArray2<f64>>,
    /// The conserved quantities, as rows.
    values: Py<PyArray2<f64>>,
    /// The attitude quaternions, as rows.
    attitudes: Py<PyArray2<f64>>,
    /// The times and the states of each event.
    events: Vec<PointArrays>,
    /// The number of iterations of all steps.
    iterations: u64,
    /// The index of the event that ended the run, if any.
    ended_by: Option<usize>,
    /// The error that ended the run, if any.
    failure: Option<PyErr>,
}

impl Recorded {
    /// Creates the columns of a record, with the numbers of coordinates and of conserved quantities.
    pub(crate) fn new(
        py: Python<'_>,
        record: Record,
        [dimension, count]: [usize; 2],
    ) -> PyResult<Self> {
        let samples = record.samples.times.len();
        let events = record.events.into_iter().map(|points| arrays(py, points, dimension));
        Ok(Self {
            times: PyArray1::from_vec(py, record.samples.times).unbind(),
            states: rows(py, record.samples.states, [samples, dimension])?.unbind(),
            values: rows(py, record.values, [samples, count])?.unbind(),
            attitudes: {
                let count = record.attitudes.len() / 4;
                rows(py, record.attitudes, [count, 4])?.unbind()
            },
            events: events.collect::<PyResult<_>>()?,
            iterations: record.iterations,
            ended_by: record.ended_by,
            failure: record.failure,
        })
    }
}

/// Returns the times and the states of points.
fn arrays(py: Python<'_>, points: Points, dimension: usize) -> PyResult<PointArrays> {
    let count = points.times.len();
    let states = rows(py, points.states, [count, dimension])?;
    Ok((PyArray1::from_vec(py, points.times).unbind(), states.unbind()))
}
