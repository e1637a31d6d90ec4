//! Poincaré sections of an energy level: states to begin at.

use super::top::Top;
use crate::arrays::rows;
use crate::errors::refused;
use crate::runs::event::direction;
use heavytop::{EnergyLevel, Section, Surface, SurfaceVariable};
use numpy::PyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::{Bound, PyRef, PyResult, Python, pyfunction};

/// The variable that is fixed, its value, and the direction 1, −1 or 0.
type SurfaceArgument = (String, f64, i8);

/// Returns states of a section with an energy and a vertical momentum, as rows.
#[pyfunction]
pub fn section_starts<'py>(
    py: Python<'py>,
    top: PyRef<'py, Top>,
    level: (f64, f64),
    surface: SurfaceArgument,
    count: usize,
    seed: u64,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let ((energy, vertical_momentum), of) = (level, *top);
    let (name, value, way) = surface;
    let variable = SurfaceVariable::named(&name)
        .ok_or_else(|| PyValueError::new_err(format!("there is no coordinate {name}")))?;
    let surface = Surface { variable, level: value, direction: direction(way)? };
    let starts = py.detach(|| {
        let level = EnergyLevel { top: of.model.top, energy, vertical_momentum };
        Section::in_axes(level, surface, &of.model.axes)?.starts(count, seed)
    });
    let starts = starts.map_err(refused)?;
    let starts: Vec<f64> = starts.iter().flat_map(|mu| of.given(mu)).collect();
    rows(py, starts, [count, 6])
}
