//! Indicators of chaos for many runs of tops.

use super::top::{Top, method_of};
use crate::arrays::read_rows;
use crate::indicators::{Indicators, Times, growth_of_models};
use crate::runs::following::MethodArgument;
use lie_poisson_runs::Model;
use numpy::PyReadonlyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::{PyRef, PyResult, Python, pyfunction};

/// Follows tangent vectors along the run of each state, with its own top or the only one, for so many exponents, or for SALI.
#[pyfunction]
pub fn growth_of_tops(
    py: Python<'_>,
    tops: Vec<PyRef<'_, Top>>,
    states: PyReadonlyArray2<'_, f64>,
    times: Times,
    method: MethodArgument,
    exponents: Option<usize>,
) -> PyResult<Indicators> {
    let states = read_rows::<6>("the states", &states)?;
    let starts: Vec<Vec<f64>> = states.iter().map(|given| given.to_vec()).collect();
    if tops.len() != 1 && tops.len() != starts.len() {
        let text = format!("there are {} tops and {} states", tops.len(), starts.len());
        return Err(PyValueError::new_err(text));
    }
    let tops: Vec<Top> = tops.iter().map(|top| **top).collect();
    let models: Vec<&dyn Model> = tops.iter().map(|top| &top.model as &dyn Model).collect();
    growth_of_models(py, &models, &starts, times, (&method_of(method)?, exponents))
}
