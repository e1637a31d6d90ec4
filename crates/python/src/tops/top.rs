//! The heavy top as a Python class.

use super::tasks::{Invariants, RecordTop};
use crate::arrays::{read_rows, rows, state};
use crate::errors::refused;
use crate::recorded::Recorded;
use crate::runs::dense::StatesAt;
use crate::runs::event::{Event, EventArgument};
use crate::runs::recording::Recording;
use crate::runs::schedule::Schedule;
use heavytop::methods::{Method, MethodError};
use heavytop::{Body, HeavyTop};
use lie_poisson::{Quaternion, Se3};
use lie_poisson_formulas::{Parameters, Vocabulary};
use nalgebra::Vector3;
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::types::{PyAnyMethods, PyType};
use pyo3::{Bound, PyResult, Python, pyclass, pymethods};

/// A heavy top: a rigid body that turns about a fixed point, under gravity.
#[pyclass(frozen, module = "heavytop._native", from_py_object)]
#[derive(Clone, Copy)]
pub struct Top(pub(crate) HeavyTop);

/// A formulation, a scheme, and the tolerance of its stage equations.
pub(crate) type MethodNames = (String, String, f64);

/// The start (Π, Γ), the step and the method of a run.
type Setting = ([f64; 6], f64, MethodNames);

/// The attitude at the start: none is recorded, or the shortest rotation, or this quaternion.
type AttitudeArgument = (bool, Option<[f64; 4]>);

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
        states: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let states = read_rows::<6>("the states", &states)?;
        let (invariants, count) = (self.0.invariants(), states.len());
        let values = states.into_iter().map(state).flat_map(|mu| {
            invariants
                .iter()
                .map(move |invariant| invariant.value(&self.0, &mu))
                .collect::<Vec<_>>()
        });
        rows(py, values.collect(), [count, invariants.len()])
    }

    /// Follows the top from (Π, Γ), and returns the columns of the run.
    fn follow(
        &self,
        py: Python<'_>,
        setting: Setting,
        end: f64,
        every: u64,
        attitude: AttitudeArgument,
        events: Vec<EventArgument>,
    ) -> PyResult<Recorded> {
        let (start, step, method) = setting;
        let (method, schedule) = (made(method)?, Schedule::new(start.into(), step, end)?);
        if every == 0 {
            return Err(PyValueError::new_err("every must be at least 1, got 0"));
        }
        let (list, events) = (self.0.invariants(), Event::all(&events, &names()?)?);
        let (attitude, initial) = attitude;
        let quantities = Invariants { top: &self.0, list: &list };
        let recording =
            Recording { schedule: &schedule, every, quantities, events: &events, attitude };
        let initial_attitude =
            initial.map(|[scalar, x, y, z]| Quaternion { scalar, vector: Vector3::new(x, y, z) });
        let task = RecordTop { recording, initial_attitude };
        let record = py.detach(|| method.integrate(&self.0, task)).map_err(refused)??;
        Recorded::new(py, record, [6, list.len()])
    }

    /// Returns the states at times in the order of the run, as rows.
    fn states_at<'py>(
        &self,
        py: Python<'py>,
        setting: Setting,
        times: Vec<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (start, step, method) = setting;
        let method = made(method)?;
        let schedule = Schedule { start: start.into(), step, steps: u64::MAX };
        let task = StatesAt { schedule: &schedule, times: &times };
        let states = py.detach(|| method.integrate(&self.0, task)).map_err(refused)??;
        rows(py, states, [times.len(), 6])
    }
}

/// Returns the names of the coordinates in events.
fn names() -> PyResult<Vocabulary> {
    Vocabulary::of(&Se3::default(), &Parameters::new()).map_err(refused)
}

/// Returns the method of these names.
pub(crate) fn made((formulation, scheme, tolerance): MethodNames) -> PyResult<Method> {
    let method = || -> Result<_, MethodError> {
        Method::new(formulation.parse()?, scheme.parse()?, tolerance)
    };
    method().map_err(refused)
}
