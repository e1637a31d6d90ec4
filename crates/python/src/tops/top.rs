//! The heavy top as a Python class.

use super::body::{BodyArguments, InertiaArgument};
use super::invariants::Invariants;
use crate::arrays::{numbers, read_rows, rows, state};
use crate::errors::refused;
use crate::recorded::Recorded;
use crate::runs::accuracy::{Accuracy, Check, accuracy, check};
use crate::runs::dense::states_at;
use crate::runs::event::{Event, EventArgument};
use crate::runs::interruption::Interruption;
use crate::runs::record::Record;
use crate::runs::recording::Recording;
use crate::runs::schedule::Schedule;
use collective_integrators::{Integrator, Start};
use heavytop::methods::{Method, MethodError};
use heavytop::{HeavyTop, Invariant, PrincipalAxes, attitude_of_vertical};
use lie_poisson::{Covector, Pair, Quaternion, Se3, Se3Dual};
use lie_poisson_formulas::{Parameters, Vocabulary};
use nalgebra::Vector3;
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::types::{PyAnyMethods, PyType};
use pyo3::{Bound, PyResult, Python, pyclass, pymethods};

/// The reason why a formulation has no attitude.
const NO_ATTITUDE: &str = "direct has no attitude: its six equations do not determine it; collective, reduced and splitting have one";

/// A heavy top: a rigid body that turns about a fixed point, under gravity.
#[pyclass(frozen, module = "heavytop._native", from_py_object)]
#[derive(Clone, Copy)]
pub struct Top {
    /// The top in its principal axes.
    pub(crate) top: HeavyTop,
    /// The principal axes, in the axes of the states that Python sees.
    pub(crate) axes: PrincipalAxes,
    /// The arguments of a top whose moments are a matrix, or about the centre of mass.
    given: Option<BodyArguments>,
}

impl From<HeavyTop> for Top {
    fn from(top: HeavyTop) -> Self {
        Self { top, axes: PrincipalAxes::aligned(top.inertia()), given: None }
    }
}

impl Top {
    /// Returns the state in principal axes of six numbers.
    ///
    /// # Errors
    /// `ValueError` if a thin rod has an angular momentum about itself.
    pub(crate) fn principal(&self, given: [f64; 6]) -> PyResult<Se3Dual> {
        let mu = self.in_axes(&given);
        self.top.require_state(&mu).map_err(refused)?;
        Ok(mu)
    }

    /// Returns the state in principal axes of six numbers, which may be one that a thin rod cannot have.
    pub(crate) fn in_axes(&self, given: &[f64; 6]) -> Se3Dual {
        self.axes.state_to_principal(&state(*given))
    }

    /// Returns the six numbers of a state in principal axes.
    pub(crate) fn given(&self, mu: &Se3Dual) -> [f64; 6] {
        numbers(&self.axes.state_from_principal(mu))
    }

    /// Replaces states in principal axes, as rows of six numbers one after the other, by those that Python sees.
    pub(crate) fn give(&self, states: &mut [f64]) {
        if !self.axes.is_aligned() {
            for row in states.as_chunks_mut::<6>().0 {
                *row = self.given(&state(*row));
            }
        }
    }
}

/// A formulation, a scheme, and the tolerance of its stage equations.
pub(crate) type MethodNames = (String, String, f64);

/// The start (Π, Γ), the step and the method of a run.
type Setting = ([f64; 6], f64, MethodNames);

/// The attitude at the start: none is recorded, or the shortest rotation, or this quaternion.
type AttitudeArgument = (bool, Option<[f64; 4]>);

/// The class of a top, and the arguments that make it.
type Reduced<'py> = (Bound<'py, PyType>, (InertiaArgument, f64, f64, f64, [f64; 3], bool));

#[pymethods]
impl Top {
    /// Creates a top from its moments of inertia, mass, gravity, length and the direction of its centre of mass.
    #[new]
    fn new(
        inertia: InertiaArgument,
        mass: f64,
        gravity: f64,
        length: f64,
        center_of_mass: [f64; 3],
        is_central: bool,
    ) -> PyResult<Self> {
        let body = BodyArguments { inertia, mass, gravity, length, center_of_mass, is_central };
        let axes = body.axes().map_err(refused)?;
        let top = body.top(&axes).map_err(refused)?;
        let given = Some(body).filter(|_| is_central || !axes.is_aligned());
        Ok(Self { top, axes, given })
    }

    /// Returns the reason why no body has these moments about the support, if there is one.
    #[staticmethod]
    fn impossibility(
        inertia: InertiaArgument,
        mass: f64,
        gravity: f64,
        length: f64,
        center_of_mass: [f64; 3],
    ) -> Option<String> {
        let is_central = false;
        BodyArguments { inertia, mass, gravity, length, center_of_mass, is_central }.impossibility()
    }

    /// Creates a free rigid body.
    #[staticmethod]
    fn free_rigid_body(inertia: [f64; 3]) -> PyResult<Self> {
        HeavyTop::free_rigid_body(Vector3::from(inertia)).map(Self::from).map_err(refused)
    }

    /// Creates Lagrange's top.
    #[staticmethod]
    fn lagrange(transverse: f64, axial: f64, weight_moment: f64) -> PyResult<Self> {
        HeavyTop::lagrange(transverse, axial, weight_moment).map(Self::from).map_err(refused)
    }

    /// Creates Kovalevskaya's top.
    #[staticmethod]
    fn kovalevskaya(axial: f64, weight_moment: f64) -> PyResult<Self> {
        HeavyTop::kovalevskaya(axial, weight_moment).map(Self::from).map_err(refused)
    }

    /// Creates the top of Goryachev and Chaplygin.
    #[staticmethod]
    fn goryachev_chaplygin(axial: f64, weight_moment: f64) -> PyResult<Self> {
        HeavyTop::goryachev_chaplygin(axial, weight_moment).map(Self::from).map_err(refused)
    }

    /// Returns what pickle needs to make an equal top.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let Self { top, given, .. } = *slf.get();
        let weight = top.weight_moment();
        let [mass, gravity] = if weight > 0.0 { [weight, 1.0] } else { [1.0, 0.0] };
        let parameters = match given {
            Some(body) => body.into(),
            None => {
                let moments = InertiaArgument::Principal(top.inertia().into());
                (moments, mass, gravity, 1.0, top.center_of_mass().into(), false)
            }
        };
        Ok((slf.get_type(), parameters))
    }

    /// The principal moments of inertia.
    #[getter]
    fn inertia(&self) -> [f64; 3] {
        self.top.inertia().into()
    }

    /// The rows of the rotation whose columns are the principal axes.
    #[getter]
    fn principal_axes(&self) -> [[f64; 3]; 3] {
        self.axes.rotation().transpose().into()
    }

    /// Returns the fastest rate of the motion through each of n states, as rows.
    fn fastest_rates(&self, states: PyReadonlyArray2<'_, f64>) -> PyResult<Vec<f64>> {
        let rate = |given: [f64; 6]| {
            let Covector(Pair(pi, gamma)) = self.in_axes(&given);
            self.top.fastest_rate(&pi, &gamma)
        };
        Ok(read_rows("the states", &states)?.into_iter().map(rate).collect())
    }

    /// The weight moment m g l.
    #[getter]
    fn weight_moment(&self) -> f64 {
        self.top.weight_moment()
    }

    /// The direction of the centre of mass.
    #[getter]
    fn center_of_mass(&self) -> [f64; 3] {
        let principal = self.top.center_of_mass();
        self.given.map_or_else(|| principal.into(), |body| body.center_of_mass)
    }

    /// The symbols of the quantities that this top conserves in every state.
    #[getter]
    fn invariants(&self) -> Vec<&'static str> {
        self.top.invariants().iter().map(|invariant| invariant.symbol()).collect()
    }

    /// Returns the symbols of the quantities that this top conserves from each of n states, as rows.
    fn invariants_from(&self, states: PyReadonlyArray2<'_, f64>) -> PyResult<Vec<&'static str>> {
        let invariants = self.conserved(&read_rows::<6>("the states", &states)?);
        Ok(invariants.iter().map(|invariant| invariant.symbol()).collect())
    }

    /// Returns the value of each of these quantities for each of n states, as n rows.
    fn invariant_values<'py>(
        &self,
        py: Python<'py>,
        states: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let states = read_rows::<6>("the states", &states)?;
        let (invariants, count) = (self.conserved(&states), states.len());
        let mut values = Vec::with_capacity(count * invariants.len());
        for given in states {
            let mu = self.in_axes(&given);
            values.extend(invariants.iter().map(|invariant| invariant.value(&self.top, &mu)));
        }
        rows(py, values, [count, invariants.len()])
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
        let first = self.principal(start)?;
        let (method, schedule) = (made(method)?, Schedule::new(numbers(&first).into(), step, end)?);
        if every == 0 {
            return Err(PyValueError::new_err("every must be at least 1, got 0"));
        }
        let turned = Some(self.axes).filter(|axes| !axes.is_aligned());
        let (list, events) =
            (self.top.invariants_from(&first), Event::all(&events, &names()?, turned)?);
        let (attitude, initial) = attitude;
        let quantities = &Invariants { top: &self.top, list: &list };
        let recording =
            Recording { schedule: &schedule, every, quantities, events: &events, attitude };
        let initial_attitude =
            initial.map(|[scalar, x, y, z]| Quaternion { scalar, vector: Vector3::new(x, y, z) });
        // In principal axes the shortest rotation is another one.
        let shortest = turned.map(|_| attitude_of_vertical(&state(start).0.1));
        let initial_attitude =
            initial_attitude.or(shortest).map(|q| self.axes.attitude_to_principal(&q));
        let record = || self.record(&method, &recording, initial_attitude);
        let mut record = py.detach(record)?;
        self.give(&mut record.samples.states);
        record.events.iter_mut().for_each(|points| self.give(&mut points.states));
        if turned.is_some() {
            // The start itself is reported, and not what rounding has made of it.
            record.samples.states.iter_mut().zip(start).for_each(|(x, given)| *x = given);
            for q in record.attitudes.as_chunks_mut::<4>().0 {
                let [scalar, x, y, z] = *q;
                let principal = Quaternion { scalar, vector: Vector3::new(x, y, z) };
                let Quaternion { scalar, vector } = self.axes.attitude_from_principal(&principal);
                *q = [scalar, vector.x, vector.y, vector.z];
            }
        }
        Recorded::new(py, record, [6, list.len()])
    }

    /// Measures how accurate a run of so many steps is: the angle of a step (rad), the estimated error, and a warning.
    fn accuracy(&self, py: Python<'_>, setting: Setting, steps: u64) -> PyResult<Accuracy> {
        let (start, step, method) = setting;
        let (method, start) = (made(method)?, self.principal(start)?);
        py.detach(|| {
            let interruption = Interruption::default();
            let measured =
                method.accuracy(&self.top, &start, (step, steps), &|| interruption.is_going());
            interruption.or(measured.map(accuracy).map_err(refused))
        })
    }

    /// Checks a run of so many steps by half the step and twice the step, and returns the error and the order.
    fn check(&self, py: Python<'_>, setting: Setting, steps: u64) -> PyResult<Check> {
        let (start, step, method) = setting;
        let (method, start) = (made(method)?, self.principal(start)?);
        py.detach(|| {
            let interruption = Interruption::default();
            let checked =
                method.check(&self.top, &start, (step, steps), &|| interruption.is_going());
            interruption.or(checked.map_err(refused).and_then(check))
        })
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
        let start = numbers(&self.principal(start)?).into();
        let schedule = Schedule { start, step, steps: u64::MAX };
        let mut states = py.detach(|| {
            let integrator = method.integrator(&self.top).map_err(refused)?;
            states_at(&integrator, &schedule, &times)
        })?;
        self.give(&mut states);
        rows(py, states, [times.len(), 6])
    }
}

impl Top {
    /// Records a run by a method, from an attitude; without one, from the shortest rotation of Γ to the vertical.
    fn record(
        &self,
        method: &Method,
        recording: &Recording<'_>,
        initial_attitude: Option<Quaternion>,
    ) -> PyResult<Record> {
        let (start, step) = (recording.schedule.start(), recording.schedule.step);
        if !recording.attitude {
            let integrator = method.integrator(&self.top).map_err(refused)?;
            let run = integrator.trajectory(&start, step).map_err(refused)?;
            return recording.follow(&integrator, run);
        }
        let integrator = method.integrator_with_attitude(&self.top).map_err(refused)?;
        let integrator = integrator.ok_or_else(|| PyValueError::new_err(NO_ATTITUDE))?;
        let mut state = integrator.start(&start).map_err(refused)?;
        let given = initial_attitude.zip(state.as_mut_slice().last_chunk_mut::<4>());
        if let Some((Quaternion { scalar, vector }, last)) = given {
            *last = [scalar, vector.x, vector.y, vector.z];
        }
        let run = integrator.trajectory_from(state, step).through(start);
        recording.follow(&integrator, run)
    }

    /// Returns the quantities that this top conserves from each of the states.
    fn conserved(&self, states: &[[f64; 6]]) -> Vec<Invariant> {
        let from = |given: &[f64; 6]| self.top.invariants_from(&self.in_axes(given));
        let mut all = states.first().map_or_else(|| self.top.invariants(), from);
        // G is the only one that depends on the state.
        if all.len() > self.top.invariants().len()
            && states.iter().any(|given| from(given).len() < all.len())
        {
            all = self.top.invariants();
        }
        all
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
