//! Inputs that some formula must name.

use super::open_arguments::{InputArgument, NoiseSource, OpenArgument};
use crate::formulas::FormulaSource;
use pyo3::PyResult;
use pyo3::exceptions::PyValueError;

/// Returns the inputs that none of some formulas names, with their places behind so many coordinates and the time.
pub(crate) fn unnamed_inputs<'a>(
    inputs: &[InputArgument],
    dimension: usize,
    formulas: impl Iterator<Item = &'a FormulaSource> + Clone,
) -> Vec<(String, usize)> {
    let placed = inputs.iter().enumerate().map(|(i, (name, ..))| (name, dimension + 1 + i));
    let idle = placed.filter(|(name, place)| !formulas.clone().any(|own| own.names(name, *place)));
    idle.map(|(name, place)| (name.clone(), place)).collect()
}

/// Returns the formulas of what drives, shakes and forces a system.
pub(crate) fn formulas_of_forces(
    (_, drive, _, noise, torque): &OpenArgument,
) -> impl Iterator<Item = &FormulaSource> + Clone {
    let fields = match noise {
        Some((NoiseSource::Fields(fields), ..)) => fields.as_slice(),
        _ => &[],
    };
    drive.iter().chain(torque).chain(fields).flatten()
}

/// Checks that some of these further formulas names each of these inputs, which would do nothing otherwise.
///
/// # Errors
/// Returns `ValueError` in the words of the program, which name the first one that none names.
pub(crate) fn require_named<'a>(
    inputs: &[(String, usize)],
    formulas: impl Iterator<Item = &'a FormulaSource> + Clone,
) -> PyResult<()> {
    let is_idle =
        |(name, place): &&(String, usize)| !formulas.clone().any(|own| own.names(name, *place));
    match inputs.iter().find(is_idle) {
        Some((name, _)) => Err(PyValueError::new_err(format!("no formula names the input {name}"))),
        None => Ok(()),
    }
}
