//! The heavy top as a Python class.

use crate::arrays::{rows, state};
use crate::errors::refused;
use crate::runs::crossings::Crossings;
use crate::runs::dense::Dense;
use crate::runs::recording::{Record, Recording};
use crate::runs::schedule::steps;
use collective_integrators::Direction;
use heavytop::methods::{Method, MethodError};
use heavytop::{Body, HeavyTop};
use nalgebra::Vector3;
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::types::{PyAnyMethods, PyType};
use pyo3::{Bound, PyErr, PyResult, Python, pyclass, pymethods};

/// A heavy top: a rigid body that turns about a fixed point, under gravity.
#[pyclass(frozen, module = "heavytop._native", from_py_object)]
#[derive(Clone, Copy)]
pub struct Top(pub(crate) HeavyTop);

/// The columns of a run: times, states, conserved quantities, attitudes, the number of iterations, and the error that
/// ended it.
type Run<'py> = (
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    u64,
    Option<PyErr>,
);

/// The times and the states of points.
type Points<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

/// A formulation, a scheme, and the tolerance of its stage equations.
type MethodNames = (String, String, f64);

/// The start (Π, Γ), the step and the method of a run.
type Setting = ([f64; 6], f64, MethodNames);

/// The class of a top, and the arguments that make it.
type Reduced<'py> = (Bound<'py, PyType>, ([f64; 3], f64, f64, f64, [f64; 3]));

#[pymethods]
impl Top {
    /// Creates a top from its principal moments, mass, gravity, length and the direction of its centre of mass.
    #[new]
    fn new(
        inertia: [f64; 3],
        mass: f64,
        gravity: f64,
        length: f64,
        center_of_mass: [f64; 3],
    ) -> PyResult<Self> {
        let [inertia, center_of_mass] = [inertia, center_of_mass].map(Vector3::from);
        let body = Body { inertia, mass, gravity, length, center_of_mass };
        HeavyTop::new(&body).map(Self).map_err(refused)
    }

    /// Creates a free rigid body.
    #[staticmethod]
    fn free_rigid_body(inertia: [f64; 3]) -> PyResult<Self> {
        HeavyTop::free_rigid_body(Vector3::from(inertia)).map(Self).map_err(refused)
    }

    /// Creates Lagrange's top.
    #[staticmethod]
    fn lagrange(transverse: f64, axial: f64, weight_moment: f64) -> PyResult<Self> {
        HeavyTop::lagrange(transverse, axial, weight_moment).map(Self).map_err(refused)
    }

    /// Creates Kovalevskaya's top.
    #[staticmethod]
    fn kovalevskaya(axial: f64, weight_moment: f64) -> PyResult<Self> {
        HeavyTop::kovalevskaya(axial, weight_moment).map(Self).map_err(refused)
    }

    /// Creates the top of Goryachev and Chaplygin.
    #[staticmethod]
    fn goryachev_chaplygin(axial: f64, weight_moment: f64) -> PyResult<Self> {
        HeavyTop::goryachev_chaplygin(axial, weight_moment).map(Self).map_err(refused)
    }

    /// Returns what pickle needs to make an equal top.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let Self(top) = *slf.get();
        let weight = top.weight_moment();
        let [mass, gravity] = if weight > 0.0 { [weight, 1.0] } else { [1.0, 0.0] };
        let parameters = (top.inertia().into(), mass, gravity, 1.0, top.center_of_mass().into());
        Ok((slf.get_type(), parameters))
    }

    /// The principal moments of inertia.
    #[getter]
    fn inertia(&self) -> [f64; 3] {
        self.0.inertia().into()
    }

    /// The weight moment m g l.
    #[getter]
    fn weight_moment(&self) -> f64 {
        self.0.weight_moment()
    }

    /// The direction of the centre of mass.
    #[getter]
    fn center_of_mass(&self) -> [f64; 3] {
        self.0.center_of_mass().into()
    }

    /// The symbols of the conserved quantities of this top.
    #[getter]
    fn invariants(&self) -> Vec<&'static str> {
        self.0.invariants().iter().map(|invariant| invariant.symbol()).collect()
    }

    /// Returns the value of each conserved quantity for each of n states, as n rows.
    fn invariant_values<'py>(
        &self,
        py: Python<'py>,
        states: numpy::PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let states = crate::arrays::read_rows::<6>("the states", &states)?;
        let invariants = self.0.invariants();
        let values = states.into_iter().map(state).flat_map(|mu| {
            invariants
                .iter()
                .map(move |invariant| invariant.value(&self.0, &mu))
                .collect::<Vec<_>>()
        });
        rows(py, values.collect(), invariants.len())
    }

    /// Follows the top from (Π, Γ), and returns times, states, conserved quantities, attitudes, the number of iterations
    /// and the error.
    fn follow<'py>(
        &self,
        py: Python<'py>,
        setting: Setting,
        end: f64,
        every: u64,
        attitude: bool,
    ) -> PyResult<Run<'py>> {
        let (start, step, method) = setting;
        let (method, steps) = (made(method)?, steps(step, end)?);
        if every == 0 {
            return Err(PyValueError::new_err("every must be at least 1, got 0"));
        }
        let (top, invariants, start) = (&self.0, &self.0.invariants()[..], state(start));
        let recording = Recording { top, invariants, start, step, steps, every, attitude };
        let record = py.detach(|| method.integrate(top, recording)).map_err(refused)??;
        let Record { times, states, invariants: values, attitudes, iterations, failure } = record;
        let (times, values) = (PyArray1::from_vec(py, times), rows(py, values, invariants.len())?);
        Ok((times, rows(py, states, 6)?, values, rows(py, attitudes, 4)?, iterations, failure))
    }

    /// Returns the states at times that do not decrease, as rows.
    fn states_at<'py>(
        &self,
        py: Python<'py>,
        setting: Setting,
        times: Vec<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (start, step, method) = setting;
        let method = made(method)?;
        let dense = Dense { start: state(start), step, times: &times };
        let states = py.detach(|| method.integrate(&self.0, dense)).map_err(refused)??;
        rows(py, states, 6)
    }

    /// Returns the times and the states at which n·(Π, Γ) = c, for a surface (n, c, direction); direction is 1, −1 or 0.
    fn crossings<'py>(
        &self,
        py: Python<'py>,
        setting: Setting,
        end: f64,
        surface: ([f64; 6], f64, i8),
        most: usize,
    ) -> PyResult<Points<'py>> {
        let ((start, step, method), (normal, level, direction)) = (setting, surface);
        let (method, steps) = (made(method)?, steps(step, end)?);
        let direction = match direction {
            1 => Direction::Up,
            -1 => Direction::Down,
            0 => Direction::Both,
            other => {
                let text = format!("direction must be 1, -1 or 0, got {other}");
                return Err(PyValueError::new_err(text));
            }
        };
        let start = state(start);
        let crossings = Crossings { start, step, steps, normal, level, direction, most };
        let found = py.detach(|| method.integrate(&self.0, crossings)).map_err(refused)??;
        Ok((PyArray1::from_vec(py, found.0), rows(py, found.1, 6)?))
    }
}

fn made((formulation, scheme, tolerance): MethodNames) -> PyResult<Method> {
    let method = || -> Result<_, MethodError> {
        Method::new(formulation.parse()?, scheme.parse()?, tolerance)
    };
    method().map_err(refused)
}
