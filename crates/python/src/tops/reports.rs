//! Quantities of tops, and reports on their motion, as Python reads them.

use crate::errors::{failed, refused};
use heavytop::methods::Method;
use lie_poisson::Quaternion;
use lie_poisson_runs::{
    Experiment, Model, Pace, ReportLine, RunFailure, Schedule, SteadyRotation, TopInAxes,
    TopQuantity, TopReport,
};
use nalgebra::Vector3;
use pyo3::exceptions::PyValueError;
use pyo3::{PyResult, Python};

/// A line of a report: its name, the measured number, its unit, and formulas with their values.
pub(super) type Line = (&'static str, Option<f64>, &'static str, Vec<(&'static str, f64)>);

/// A steady rotation: the vertical in the axes of the users, the rate, the energy, the growth, whether it is one of a circle,
/// and the least angle from the run.
pub(super) type Steady = ([f64; 3], f64, f64, f64, bool, f64);

/// A report: the kind of the top, its lines, steady rotations, and all as a table.
pub(super) type Report = (&'static str, Vec<Line>, Vec<Steady>, String);

/// Returns the values of a quantity of a top at states with attitudes, one after the other, and how many a state has.
///
/// # Errors
/// Returns `ValueError` if there is no such quantity.
pub(super) fn quantity(
    model: &TopInAxes,
    name: &str,
    states: &[[f64; 6]],
    attitudes: &[[f64; 4]],
) -> PyResult<(Vec<f64>, usize)> {
    let found = TopQuantity::NAMES.iter().find(|(known, _)| *known == name);
    let Some((_, quantity)) = found else {
        return Err(PyValueError::new_err(format!("there is no quantity {name}")));
    };
    let mut values = Vec::with_capacity(states.len() * quantity.columns().len());
    for (state, [scalar, x, y, z]) in states.iter().zip(attitudes) {
        let attitude = Quaternion { scalar: *scalar, vector: Vector3::new(*x, *y, *z) };
        // A top of Python has no distance of its centre of mass, which only the height needs.
        quantity.append(model, (&TopInAxes::state(state), Some(&attitude)), f64::NAN, &mut values);
    }
    Ok((values, quantity.columns().len()))
}

/// Follows a top and reports on its motion.
///
/// # Errors
/// Returns `ValueError` if there is no such run, and `IntegrationError` if a step fails.
pub(super) fn report(
    py: Python<'_>,
    model: TopInAxes,
    (given, method): (&[f64], Method),
    (step, end): (f64, f64),
) -> PyResult<Report> {
    let schedule = Schedule::new(step, end).map_err(refused)?;
    let start = model.start(given).map_err(refused)?;
    let pace = Pace { schedule, every: 1 };
    let run = Experiment { start, method, pace, attitude: true, model };
    let report = py.detach(|| TopReport::new(&run, None)).map_err(|error| match error {
        RunFailure::Integration { .. } | RunFailure::NoValue { .. } => failed(error),
        error => refused(error),
    })?;
    let line = |line: ReportLine| {
        (line.name, line.measured.filter(|value| value.is_finite()), line.unit, line.formulas)
    };
    let steady = |one: SteadyRotation| {
        (one.vertical.into(), one.rate, one.energy, one.growth, one.is_circle, one.nearest)
    };
    let text = report.to_string();
    let TopReport { kind, lines, steady: rotations, .. } = report;
    let (lines, rotations) =
        (lines.into_iter().map(line).collect(), rotations.into_iter().map(steady).collect());
    Ok((kind, lines, rotations, text))
}
