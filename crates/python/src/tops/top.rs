//! The heavy top as a Python class.

use super::body::{BodyArguments, InertiaArgument};
use super::reports::{Report, quantity, report};
use crate::arrays::{read_rows, rows};
use crate::errors::refused;
use crate::recorded::Recorded;
use crate::runs::accuracy::{Accuracy, Check};
use crate::runs::event::{Event, EventArgument};
use crate::runs::following::{Following, MethodArgument, Setting, present};
use collective_integrators::diagnostics::SystemScales;
use heavytop::methods::{Formulation, Method, MethodError};
use heavytop::{HeavyTop, Invariant, attitude_of_vertical};
use lie_poisson::{Quaternion, Se3Dual};
use lie_poisson_formula_systems::{NamedInputs, SystemAlgebra};
use lie_poisson_formulas::{Parameters, Vocabulary};
use lie_poisson_runs::{Model, TopInAxes};
use nalgebra::Vector3;
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::types::{PyAnyMethods, PyType};
use pyo3::{Bound, PyResult, Python, pyclass, pymethods};

/// A heavy top: a rigid body that turns about a fixed point, under gravity.
#[pyclass(frozen, module = "heavytop._native", from_py_object)]
#[derive(Clone, Copy)]
pub struct Top {
    /// The top, and the axes of the states that Python sees.
    pub(crate) model: TopInAxes,
    /// The arguments of a top whose moments are a matrix, or about the centre of mass.
    given: Option<BodyArguments>,
}

impl From<HeavyTop> for Top {
    fn from(top: HeavyTop) -> Self {
        Self { model: top.into(), given: None }
    }
}

impl Top {
    /// Returns the state in principal axes of six numbers.
    ///
    /// # Errors
    /// `ValueError` if a thin rod has an angular momentum about itself.
    pub(crate) fn principal(&self, given: [f64; 6]) -> PyResult<Se3Dual> {
        Ok(TopInAxes::state(&self.model.start(&given).map_err(refused)?))
    }

    /// Returns the state in principal axes of six numbers, which may be one that a thin rod cannot have.
    pub(crate) fn in_axes(&self, given: &[f64; 6]) -> Se3Dual {
        self.model.axes.state_to_principal(&TopInAxes::state(given))
    }

    /// Returns the six numbers of a state in principal axes.
    pub(crate) fn given(&self, mu: &Se3Dual) -> [f64; 6] {
        TopInAxes::coordinates(&self.model.given(mu))
    }
}

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
        Ok(Self { model: TopInAxes { axes, ..top.into() }, given })
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
        let Self { model: TopInAxes { top, .. }, given } = *slf.get();
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
        self.model.top.inertia().into()
    }

    /// The rows of the rotation whose columns are the principal axes.
    #[getter]
    fn principal_axes(&self) -> [[f64; 3]; 3] {
        self.model.axes.rotation().transpose().into()
    }

    /// Returns the fastest rate of the motion through each of n states, as rows.
    fn fastest_rates(&self, states: PyReadonlyArray2<'_, f64>) -> PyResult<Vec<f64>> {
        let rate = |given: [f64; 6]| {
            self.model.fastest_rate(&TopInAxes::coordinates(&self.in_axes(&given)))
        };
        Ok(read_rows("the states", &states)?.into_iter().map(rate).collect())
    }

    /// The weight moment m g l.
    #[getter]
    fn weight_moment(&self) -> f64 {
        self.model.top.weight_moment()
    }

    /// The direction of the centre of mass.
    #[getter]
    fn center_of_mass(&self) -> [f64; 3] {
        let principal = self.model.top.center_of_mass();
        self.given.map_or_else(|| principal.into(), |body| body.center_of_mass)
    }

    /// The symbols of the quantities that this top conserves in every state.
    #[getter]
    fn invariants(&self) -> Vec<&'static str> {
        self.model.top.invariants().iter().map(|invariant| invariant.symbol()).collect()
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
            values.extend(invariants.iter().map(|invariant| invariant.value(&self.model.top, &mu)));
        }
        rows(py, values, [count, invariants.len()])
    }

    /// Returns a quantity of each of n states with attitudes, as n rows.
    fn quantity<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        states: PyReadonlyArray2<'py, f64>,
        attitudes: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let states = read_rows("the states", &states)?;
        let attitudes = read_rows("the attitudes", &attitudes)?;
        let (values, width) = quantity(&self.model, name, &states, &attitudes)?;
        rows(py, values, [states.len(), width])
    }

    /// Follows the top from (Π, Γ) to the end, and returns a report on its motion.
    fn report(&self, py: Python<'_>, setting: Setting, end: f64) -> PyResult<Report> {
        let (start, step, method) = setting;
        report(py, self.model, (&start, method_of(method)?), (step, end))
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
        let axes = self.model.axes;
        let turned = Some(axes).filter(|axes| !axes.is_aligned());
        let events = Event::all(&events, &names()?, &self.model)?;
        let (has_attitude, initial) = attitude;
        let initial =
            initial.map(|[scalar, x, y, z]| Quaternion { scalar, vector: Vector3::new(x, y, z) });
        // In principal axes the shortest rotation is another one.
        let shortest = turned.map(|_| attitude_of_vertical(&TopInAxes::state(&setting.0).0.1));
        let initial = initial.or(shortest).map(|q| axes.attitude_to_principal(&q));
        let initial = has_attitude.then_some(initial);
        let run = self.following(&setting)?;
        let (mut record, widths) = run.record(py, (end, every), &events, initial)?;
        present(&self.model, &mut record.samples.states, widths[0]);
        for points in &mut record.events {
            present(&self.model, &mut points.states, widths[0]);
        }
        if turned.is_some() {
            // The start itself is reported, and not what rounding has made of it.
            let states = record.samples.states.iter_mut();
            states.zip(&setting.0).for_each(|(x, given)| *x = *given);
            for q in record.attitudes.as_chunks_mut::<4>().0 {
                let [scalar, x, y, z] = *q;
                let principal = Quaternion { scalar, vector: Vector3::new(x, y, z) };
                let Quaternion { scalar, vector } = axes.attitude_from_principal(&principal);
                *q = [scalar, vector.x, vector.y, vector.z];
            }
        }
        Recorded::new(py, record, widths)
    }

    /// Measures how accurate a run of so many steps is: the angle of a step (rad), the estimated error, and a warning.
    fn accuracy(&self, py: Python<'_>, setting: Setting, steps: u64) -> PyResult<Accuracy> {
        self.following(&setting)?.accuracy(py, steps)
    }

    /// Checks a run of so many steps by half the step and twice the step, and returns the error and the order.
    fn check(&self, py: Python<'_>, setting: Setting, steps: u64) -> PyResult<Check> {
        self.following(&setting)?.check(py, steps)
    }

    /// Returns the states at times in the order of the run, as rows.
    fn states_at<'py>(
        &self,
        py: Python<'py>,
        setting: Setting,
        times: Vec<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.following(&setting)?.states_at(py, &times)
    }
}

impl Top {
    /// Returns what is done along the run of a setting.
    fn following(&self, (start, step, method): &Setting) -> PyResult<Following<'_>> {
        Following::new(&self.model, method_of(method.clone())?, (start, *step))
    }

    /// Returns the quantities that this top conserves from each of the states.
    fn conserved(&self, states: &[[f64; 6]]) -> Vec<Invariant> {
        let from = |given: &[f64; 6]| self.model.top.invariants_from(&self.in_axes(given));
        let mut all = states.first().map_or_else(|| self.model.top.invariants(), from);
        // G is the only one that depends on the state.
        if all.len() > self.model.top.invariants().len()
            && states.iter().any(|given| from(given).len() < all.len())
        {
            all = self.model.top.invariants();
        }
        all
    }
}

/// Returns the names of the coordinates and the time in events.
fn names() -> PyResult<Vocabulary> {
    let algebra = SystemAlgebra::named("se(3)").map_err(refused)?;
    let names = NamedInputs::default().vocabulary_of_functions(&algebra, &Parameters::new());
    names.map_err(refused)
}

/// Returns the method of these names.
pub(crate) fn method_of((formulation, scheme, tolerance): MethodArgument) -> PyResult<Method> {
    let method = || -> Result<_, MethodError> {
        let formulation = formulation.map_or(Ok(Formulation::default()), |name| name.parse())?;
        Method::new(formulation, scheme.parse()?, tolerance)
    };
    method().map_err(refused)
}
