//! Conversion between arrays of NumPy and states.

use lie_poisson::{Covector, Pair, Se3Dual};
use nalgebra::Vector3;
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

/// Returns the state (Π, Γ) of six numbers.
pub(crate) fn state([a, b, c, x, y, z]: [f64; 6]) -> Se3Dual {
    Se3Dual::new(Vector3::new(a, b, c), Vector3::new(x, y, z))
}

/// Returns the state (Π, Γ) of a run.
pub(crate) fn state_of(momentum: &[f64]) -> Se3Dual {
    momentum.first_chunk().map_or_else(|| state([f64::NAN; 6]), |numbers| state(*numbers))
}

/// Returns the six numbers of a state (Π, Γ).
pub(crate) fn numbers(Covector(Pair(pi, gamma)): &Se3Dual) -> [f64; 6] {
    [pi.x, pi.y, pi.z, gamma.x, gamma.y, gamma.z]
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
