//! A system of arrays, such as a lattice of spins, as a Python class.

use super::algebra::ParameterArgument;
use super::open::{ArrayTermsArgument, ModelOfRun, WITHOUT_PATH};
use crate::arrays::rows;
use crate::errors::refused;
use crate::recorded::Recorded;
use crate::runs::accuracy::{Accuracy, Check};
use crate::runs::event::{CallbackArgument, Event};
use crate::runs::following::{Following, MethodArgument, Setting, present};
use core::f64::consts::PI;
use heavytop::methods::{Method, MethodError};
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_runs::{
    Arguments, ArrayKind, ArraySystem, ArrayTerms, Model, OpenArrays, RunFailure,
};
use numpy::{PyArray1, PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::types::{PyAnyMethods, PyType};
use pyo3::{Bound, PyResult, Python, pyclass, pymethods};

/// The kind, the parameters, and the friction, the forces and the noise.
type Source = (String, Vec<ParameterArgument>, Option<ArrayTermsArgument>);

/// A system whose states are arrays.
#[derive(Clone)]
#[pyclass(frozen, module = "heavytop._native")]
pub struct Arrays {
    system: ArraySystem,
    /// The friction, the forces and the noise.
    terms: Option<ArrayTerms>,
    source: Source,
}

#[pymethods]
impl Arrays {
    /// Creates the system of a kind with these parameters.
    #[new]
    fn new(
        kind: String,
        arguments: Vec<ParameterArgument>,
        open: Option<ArrayTermsArgument>,
    ) -> PyResult<Self> {
        let Some(found) = ArrayKind::named(&kind) else {
            let all: Vec<_> = ArrayKind::ALL.iter().map(|kind| kind.name).collect();
            let text = format!("there is no system of arrays {kind}; there are {}", all.join(", "));
            return Err(PyValueError::new_err(text));
        };
        let system = found.system(&given(&arguments)).map_err(refused)?;
        let terms = open.as_ref().map(ArrayTermsArgument::terms).transpose()?;
        let made = Self { system, terms, source: (kind, arguments, open) };
        // What does not fit is refused here, whatever the step will be.
        made.unit_model()?;
        Ok(made)
    }

    /// The name and the shape of each array of a state.
    #[getter]
    fn arrays(&self) -> Vec<(&'static str, Vec<usize>)> {
        self.system.arrays()
    }

    /// The symbols of what is conserved, or would be without friction, forces and noise.
    #[getter]
    fn invariants(&self) -> PyResult<Vec<String>> {
        Ok(self.unit_model()?.conserved(&[]).names())
    }

    /// Whether there is friction, a force or noise.
    #[getter]
    fn is_open(&self) -> bool {
        self.terms.is_some()
    }

    /// Whether there is noise.
    #[getter]
    fn has_noise(&self) -> PyResult<bool> {
        Ok(self.unit_model()?.noise().is_some())
    }

    /// Whether the motion keeps each of them.
    #[getter]
    fn kept(&self) -> PyResult<Vec<bool>> {
        let model = self.unit_model()?;
        let conserved = model.conserved(&[]);
        Ok(conserved.names().iter().map(|name| conserved.is_kept(name)).collect())
    }

    /// Returns the system on another path of its noise.
    fn on_path(&self, path: u64) -> PyResult<Self> {
        let mut source = self.source.clone();
        let number = source.2.as_mut().and_then(ArrayTermsArgument::path_mut);
        *number.ok_or_else(|| PyValueError::new_err(WITHOUT_PATH))? = path;
        let terms = source.2.as_ref().map(ArrayTermsArgument::terms).transpose()?;
        let other = Self { system: self.system.clone(), terms, source };
        other.unit_model()?;
        Ok(other)
    }

    /// The Hamiltonian as text.
    #[getter]
    fn hamiltonian(&self) -> Option<String> {
        self.system.formula("h")
    }

    /// The formulations that the system has, the default one first.
    #[getter]
    fn formulations(&self) -> Vec<&'static str> {
        let opened = self.system.kind().opened;
        if let (Some(_), Some(formulation)) = (&self.terms, opened) {
            return vec![formulation.name()];
        }
        self.system.formulations().iter().map(|formulation| formulation.name()).collect()
    }

    /// Returns what pickle needs to make an equal system.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, Source) {
        (slf.get_type(), slf.get().source.clone())
    }

    /// Returns the state that is given by the parameters of a start.
    fn start<'py>(
        &self,
        py: Python<'py>,
        arguments: Vec<ParameterArgument>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let state = self.system.start_of(&given(&arguments)).map_err(refused)?;
        Ok(PyArray1::from_vec(py, state))
    }

    /// Returns what is conserved of each of n states at n times, or at the time 0, as n rows.
    #[pyo3(signature = (states, times=None))]
    fn invariant_values<'py>(
        &self,
        py: Python<'py>,
        states: PyReadonlyArray2<'py, f64>,
        times: Option<Vec<f64>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let model = self.unit_model()?;
        let conserved = model.conserved(&[]);
        let mut times = times.into_iter().flatten();
        self.each(py, &states, |given| {
            let (state, time) = (Model::start(&self.system, given)?, times.next().unwrap_or(0.0));
            let values = conserved.values(time, &state);
            values.map_err(|reason| RunFailure::NoValue { time, reason })
        })
    }

    /// Returns the values of a field on the sphere on a grid of so many circles, of each of n states, as n rows.
    fn on_grid<'py>(
        &self,
        py: Python<'py>,
        states: PyReadonlyArray2<'py, f64>,
        rows: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let colatitude = |i: usize| PI * (i as f64 + 0.5) / rows as f64;
        self.each(py, &states, |given| {
            let circle = |i| self.system.on_circle(given, colatitude(i), 2 * rows);
            Ok((0..rows).filter_map(circle).flatten().collect())
        })
    }

    /// Returns the rate of each of n states at a time, as n rows; with noise the drift.
    #[pyo3(signature = (states, time=0.0))]
    fn rates<'py>(
        &self,
        py: Python<'py>,
        states: PyReadonlyArray2<'py, f64>,
        time: f64,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let model = self.unit_model()?;
        self.each(py, &states, |given| match &model {
            ModelOfRun::OpenArrays(open) => open.rate(given, time),
            _ => self.system.rate(given),
        })
    }

    /// Returns the fastest rate of the motion through each of n states, as rows.
    fn fastest_rates(&self, states: PyReadonlyArray2<'_, f64>) -> PyResult<Vec<f64>> {
        let model = self.unit_model()?;
        let rate = |given: Vec<f64>| {
            Ok(model.fastest_rate(&Model::start(&self.system, &given).map_err(refused)?))
        };
        states.as_array().outer_iter().map(|row| rate(row.to_vec())).collect()
    }

    /// Follows the system, and returns the columns of the run.
    fn follow(
        &self,
        py: Python<'_>,
        setting: Setting,
        end: f64,
        every: u64,
        events: Vec<CallbackArgument>,
    ) -> PyResult<Recorded> {
        let model = self.model(setting.1)?;
        model.require_until(end)?;
        let run = self.following(&model, &setting)?;
        let events = events.iter().map(|event| Event::of_callback(event, &self.system));
        let events = events.collect::<PyResult<Vec<_>>>()?;
        let (mut record, widths) = run.record(py, (end, every), &events, None)?;
        py.detach(|| {
            let points = record.events.iter_mut().chain([&mut record.samples]);
            points.for_each(|points| present(&self.system, &mut points.states, widths[0]));
        });
        Recorded::new(py, record, widths)
    }

    /// Measures how accurate a run of so many steps is: the angle of a step (rad), the estimated error, and a warning.
    fn accuracy(&self, py: Python<'_>, setting: Setting, steps: u64) -> PyResult<Accuracy> {
        let model = self.model(setting.1)?;
        self.following(&model, &setting)?.accuracy(py, steps)
    }

    /// Checks a run of so many steps by half the step and twice the step, and returns the error and the order.
    fn check(&self, py: Python<'_>, setting: Setting, steps: u64) -> PyResult<Check> {
        let model = self.model(setting.1)?;
        self.following(&model, &setting)?.check(py, steps)
    }

    /// Returns the states at times in the order of the run, as rows.
    fn states_at<'py>(
        &self,
        py: Python<'py>,
        setting: Setting,
        times: Vec<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let model = self.model(setting.1)?;
        model.require_until(times.last().copied().unwrap_or(0.0))?;
        self.following(&model, &setting)?.states_at(py, &times)
    }
}

impl Arrays {
    /// Returns the model of a run with steps of a size.
    pub(crate) fn model(&self, step: f64) -> PyResult<ModelOfRun<'_>> {
        let Some(terms) = &self.terms else { return Ok(ModelOfRun::Arrays(&self.system)) };
        let open = OpenArrays::new(self.system.clone(), terms.clone(), step).map_err(refused)?;
        Ok(ModelOfRun::OpenArrays(Box::new(open)))
    }

    /// Returns the model of no run, with the step of its noise, or 1.
    fn unit_model(&self) -> PyResult<ModelOfRun<'_>> {
        let interval = self.terms.as_ref().and_then(|terms| terms.paths()?.interval);
        self.model(interval.unwrap_or(1.0))
    }

    fn following<'a>(
        &self,
        model: &'a ModelOfRun<'_>,
        (start, step, method): &Setting,
    ) -> PyResult<Following<'a>> {
        Following::new(&**model, self.method(method.clone())?, (start, *step))
    }

    /// Returns the method of these names.
    pub(crate) fn method(
        &self,
        (formulation, scheme, tolerance): MethodArgument,
    ) -> PyResult<Method> {
        let model = self.unit_model()?;
        let method = || -> Result<Method, FormulaSystemError> {
            let formulation = formulation.map(|name| name.parse().map_err(MethodError::from));
            let scheme = scheme.parse().map_err(MethodError::from)?;
            let formulation = formulation.transpose()?;
            match &model {
                ModelOfRun::OpenArrays(open) => open.method(formulation, Some(scheme), tolerance),
                _ => self.system.method(formulation, scheme, tolerance),
            }
        };
        method().map_err(refused)
    }

    /// Returns a function of each state, as rows.
    fn each<'py>(
        &self,
        py: Python<'py>,
        states: &PyReadonlyArray2<'py, f64>,
        mut function: impl FnMut(&[f64]) -> Result<Vec<f64>, RunFailure>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (mut values, count) = (Vec::new(), states.as_array().nrows());
        for state in states.as_array().outer_iter() {
            values.extend(function(&state.to_vec()).map_err(refused)?);
        }
        let width = values.len().checked_div(count).unwrap_or(0);
        rows(py, values, [count, width])
    }
}

/// Returns the numbers and lists of the arguments.
fn given(arguments: &[ParameterArgument]) -> Arguments {
    arguments.iter().fold(Arguments::new(), |all, (name, values, is_list)| {
        match (values.as_slice(), is_list) {
            (&[value], false) => all.number(name, value),
            (values, _) => all.list(name, values.to_vec()),
        }
    })
}
