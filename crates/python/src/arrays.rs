//! Conversion between arrays of NumPy and states.

use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::{Bound, PyResult, Python};

/// Returns an array of rows.
pub(crate) fn rows<'py>(
    py: Python<'py>,
    values: Vec<f64>,
    shape: [usize; 2],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    PyArray1::from_vec(py, values).reshape(shape)
}

/// Returns the rows of an array, each with `N` numbers.
pub(crate) fn read_rows<const N: usize>(
    name: &str,
    array: &PyReadonlyArray2<'_, f64>,
) -> PyResult<Vec<[f64; N]>> {
    let shape = array.shape();
    if shape.get(1) != Some(&N) {
        let text = format!("{name} must have the shape (n, {N}), got {shape:?}");
        return Err(PyValueError::new_err(text));
    }
    let view = array.as_array();
    Ok(view.outer_iter().map(|row| core::array::from_fn(|i| row[i])).collect())
}
