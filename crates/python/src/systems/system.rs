//! A Lie–Poisson system as a Python class.

use super::algebra::{
    AlgebraSource, Groups, ParameterArgument, Realisation, groups, parameters, realised,
};
use super::named_inputs::{formulas_of_forces, require_named, unnamed_inputs};
use super::open::{ModelOfRun, WITHOUT_PATH, inputs, of_formula, terms};
use super::open_arguments::OpenArgument;
use crate::arrays::rows;
use crate::errors::refused;
use crate::formulas::FormulaSource;
use crate::recorded::Recorded;
use crate::runs::accuracy::{Accuracy, Check};
use crate::runs::event::{Event, EventArgument};
use crate::runs::following::{BalanceNumbers, Following, MethodArgument, Setting};
use crate::runs::interruption::until_interrupted;
use collective_integrators::diagnostics::SystemScales;
use core::sync::atomic::Ordering;
use heavytop::methods::{Formulation, Method, MethodError};
use lie_poisson_formula_systems::{
    FormulaSystem, FormulaSystemError, OpenNames, OpenSystem, OpenTerms, SystemKind, Verdict,
};
use lie_poisson_formulas::Vocabulary;
use lie_poisson_runs::Model;
use numpy::{PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::types::{PyAnyMethods, PyType};
use pyo3::{Bound, PyResult, Python, pyclass, pymethods};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// A Lie–Poisson system: an algebra, a Hamiltonian, and the Casimirs that were found.
#[derive(Clone)]
#[pyclass(frozen, module = "heavytop._native")]
pub struct System {
    pub(crate) system: FormulaSystem,
    /// What makes it an open system.
    terms: Option<OpenTerms>,
    names: Vocabulary,
    /// The inputs that none of its formulas names, with their places: events may.
    idle: Vec<(String, usize)>,
    source: Source,
}

/// The arguments from which a system is made; a system by name has no Hamiltonian of its own.
type Source = (
    AlgebraSource,
    Option<FormulaSource>,
    Vec<ParameterArgument>,
    bool,
    Option<Realisation>,
    Option<OpenArgument>,
);

/// Returns the step of a model that makes no steps: that of its noise, or 1.
fn unit_of(terms: Option<&OpenTerms>) -> f64 {
    terms.and_then(|terms| terms.noise.as_ref()?.interval).unwrap_or(1.0)
}

#[pymethods]
impl System {
    /// Creates the system and finds the Casimirs of its algebra.
    #[new]
    fn new(
        py: Python<'_>,
        algebra: AlgebraSource,
        hamiltonian: Option<FormulaSource>,
        arguments: Vec<ParameterArgument>,
        has_plus_bracket: bool,
        realisation: Option<Realisation>,
        mut open: Option<OpenArgument>,
    ) -> PyResult<Self> {
        let mut given = parameters(&arguments)?;
        let mut inputs = inputs(open.as_ref().map_or(&[], |open| &open.0))?;
        let (system, own, in_time) = match (&algebra, &hamiltonian) {
            (AlgebraSource::OfKind((name,)), None) => {
                let kind = SystemKind::named(name).map_err(refused)?;
                let orbit = kind.orbit(&given).map_err(refused)?;
                if orbit.is_some() {
                    // A Hamiltonian of the time makes the system an open one, without forces, too.
                    open = open.or_else(|| Some(OpenArgument::default()));
                    inputs = inputs.with_orbit(orbit);
                }
                let of_kind = || OpenNames::of_kind(kind, given.clone(), &inputs, None);
                let made = match &open {
                    None => (py.detach(|| kind.system(&given)).map_err(refused)?, None, None),
                    Some(_) => {
                        let (system, own, in_time) = py.detach(of_kind).map_err(refused)?;
                        (system, Some(own), in_time)
                    }
                };
                given = kind.with_circle(given).map_err(refused)?;
                made
            }
            (_, Some(hamiltonian)) => {
                let named = algebra.algebra(&given)?;
                let named = match &realisation {
                    Some(realisation) => realised(named, realisation)?,
                    None => named,
                };
                let forces = open.as_ref().map(|_| &inputs);
                let (system, in_time) = of_formula(&named, hamiltonian, &given, forces)?;
                let signed = |system: FormulaSystem| match has_plus_bracket {
                    true => system.with_plus_bracket(),
                    false => Ok(system),
                };
                let find = || signed(system).and_then(FormulaSystem::with_found_casimirs);
                (py.detach(find).map_err(refused)?, None, in_time)
            }
            _ => return Err(PyValueError::new_err("write a Hamiltonian, or the name of a system")),
        };
        // What the user has given has names in events, too.
        let names = inputs.vocabulary_of_functions(system.algebra(), &given).map_err(refused)?;
        let terms = match &open {
            None => None,
            Some(open) => {
                let own = match own {
                    Some(own) => own,
                    None => {
                        OpenNames::new(system.algebra().clone(), &inputs, given).map_err(refused)?
                    }
                };
                let terms = terms(&own, inputs, in_time, open)?;
                // What does not fit is refused here, whatever the step will be.
                OpenSystem::new(system.clone(), terms.clone(), unit_of(Some(&terms)))
                    .map_err(refused)?;
                Some(terms)
            }
        };
        let idle = open.as_ref().map_or_else(Vec::new, |open| {
            let formulas = hamiltonian.iter().chain(formulas_of_forces(open));
            unnamed_inputs(&open.0, system.algebra().dimension(), formulas)
        });
        let source = (algebra, hamiltonian, arguments, has_plus_bracket, realisation, open);
        Ok(Self { system, terms, names, idle, source })
    }

    /// The names of the scalars and vectors of coordinates, with their dimensions; 0 for a scalar.
    #[getter]
    fn groups(&self) -> Groups {
        groups(self.system.algebra())
    }

    /// The sign of the bracket.
    #[getter]
    fn has_plus_bracket(&self) -> bool {
        self.system.has_plus_bracket()
    }

    /// Returns what pickle needs to make an equal system.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, Source) {
        (slf.get_type(), slf.get().source.clone())
    }

    /// The Hamiltonian as text.
    #[getter]
    fn hamiltonian(&self) -> String {
        self.system.hamiltonian().to_string()
    }

    /// The Casimirs as text.
    #[getter]
    fn casimirs(&self) -> Vec<String> {
        self.system.casimirs().iter().map(ToString::to_string).collect()
    }

    /// The number of independent Casimirs that were not found.
    #[getter]
    fn missing_casimirs(&self) -> usize {
        self.system.missing_casimirs().unwrap_or(0)
    }

    /// The structure constants (i, j, k, c) with i < j that are not zero.
    #[getter]
    fn structure_constants(&self) -> Vec<(usize, usize, usize, f64)> {
        let entries = self.system.algebra().entries().iter();
        entries.map(|entry| (entry.i, entry.j, entry.k, entry.value)).collect()
    }

    /// Whether the motion keeps h and each of the Casimirs.
    #[getter]
    fn kept(&self) -> PyResult<Vec<bool>> {
        let model = self.model(unit_of(self.terms.as_ref()))?;
        let conserved = model.conserved(&[]);
        Ok(conserved.names().iter().map(|name| conserved.is_kept(name)).collect())
    }

    /// Returns the system on another path of its noise.
    fn on_path(&self, path: u64) -> PyResult<Self> {
        let mut other = self.clone();
        let of_terms = other.terms.as_mut().and_then(|terms| terms.noise.as_mut());
        let of_source = other.source.5.as_mut().and_then(|open| open.3.as_mut());
        let (Some(noise), Some((_, (_, source, ..), _))) = (of_terms, of_source) else {
            return Err(PyValueError::new_err(WITHOUT_PATH));
        };
        (noise.path, *source) = (path, path);
        other.model(unit_of(other.terms.as_ref()))?;
        Ok(other)
    }

    /// Whether the Hamiltonian depends on the time, or something drives, damps, shakes or forces the system.
    #[getter]
    fn is_open(&self) -> bool {
        self.terms.is_some()
    }

    /// The formulations that the algebra has, the default one first.
    #[getter]
    fn formulations(&self) -> Vec<String> {
        let algebra = self.system.algebra();
        let first = algebra.default_formulation();
        let all = match &self.terms {
            Some(terms) => terms.formulations(algebra),
            None => core::iter::once(first)
                .chain(algebra.formulations().filter(|other| *other != first))
                .collect(),
        };
        all.iter().map(|formulation| formulation.name().to_owned()).collect()
    }

    /// What the realisation obeys along which collective steps go, if it is one by matrices: whether its bracket is the plus
    /// bracket, the defect of the brackets, the rank, and the defect of the odd powers.
    #[getter]
    fn verdict(&self) -> Option<(bool, f64, usize, f64)> {
        let verdict = self.system.algebra().verdict()?;
        let Verdict { is_plus, defect, rank, odd_powers } = verdict;
        Some((is_plus, defect, rank, odd_powers))
    }

    /// Returns h and the Casimirs of each of n states, as n rows; at these times, or at 0.
    #[pyo3(signature = (states, times=None))]
    fn invariant_values<'py>(
        &self,
        py: Python<'py>,
        states: PyReadonlyArray2<'py, f64>,
        times: Option<Vec<f64>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let width = 1 + self.system.casimirs().len();
        if self.terms.is_none() {
            return self.each(py, &states, width, |_, state| {
                self.system.invariants(state).map_err(refused)
            });
        }
        let model = self.model(unit_of(self.terms.as_ref()))?;
        let conserved = model.conserved(&[]);
        self.each(py, &states, width, |i, state| {
            let time = times.as_ref().and_then(|times| times.get(i)).copied().unwrap_or(0.0);
            conserved.values(time, state).map_err(PyValueError::new_err)
        })
    }

    /// Returns the rate of each of n states, as n rows, at a time; with noise the drift.
    #[pyo3(signature = (states, time=0.0))]
    fn rates<'py>(
        &self,
        py: Python<'py>,
        states: PyReadonlyArray2<'py, f64>,
        time: f64,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let model = self.model(unit_of(self.terms.as_ref()))?;
        self.each(py, &states, self.system.algebra().dimension(), |_, state| match &model {
            ModelOfRun::Open(open) => open.rate(state, time).map_err(refused),
            _ => self.system.rate(state).map_err(refused),
        })
    }

    /// Returns the fastest rate of the motion through each of n states, as rows. It finds eigenvalues, on all threads.
    fn fastest_rates(
        &self,
        py: Python<'_>,
        states: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<Vec<f64>> {
        let states: Vec<Vec<f64>> =
            states.as_array().outer_iter().map(|row| row.to_vec()).collect();
        until_interrupted(py, |stop| {
            let rate = |state: &Vec<f64>| match stop.load(Ordering::Relaxed) {
                true => f64::NAN,
                false => self.system.fastest_rate(state),
            };
            states.par_iter().map(rate).collect()
        })
    }

    /// Follows the system, and returns the columns of the run.
    fn follow(
        &self,
        py: Python<'_>,
        setting: Setting,
        end: f64,
        every: u64,
        events: Vec<EventArgument>,
    ) -> PyResult<Recorded> {
        let model = self.model(setting.1)?;
        self.require_named_inputs(&events)?;
        for (function, ..) in &events {
            model.require_zeros(&function.formula(&self.names)?)?;
        }
        let events = Event::all(&events, &self.names, &*model)?;
        model.require_until(end)?;
        let run = self.following(&model, &setting)?;
        model.conserved(&setting.0).values(0.0, &setting.0).map_err(PyValueError::new_err)?;
        let (record, widths) = run.record(py, (end, every), &events, None)?;
        Recorded::new(py, record, widths)
    }

    /// Returns a warning about invariants of which a motion from a start to an end has used up the digits.
    fn warning_of_end(&self, start: Vec<f64>, end: Vec<f64>) -> Option<String> {
        let warning = Model::warning_of_end(&self.system, &start, &end)?;
        Some(warning.trim_start_matches("warning: ").to_owned())
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

    /// Measures how forces change the conserved quantities in a run of so many steps.
    fn balances(
        &self,
        py: Python<'_>,
        setting: Setting,
        steps: u64,
    ) -> PyResult<Vec<BalanceNumbers>> {
        let model = self.model(setting.1)?;
        self.following(&model, &setting)?.balances(py, steps)
    }

    /// Checks that a formula of the system names each of the inputs, for a run without events.
    fn require_inputs(&self) -> PyResult<()> {
        self.require_named_inputs(&[])
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

impl System {
    /// Returns the model of a run with steps of a size.
    pub(crate) fn model(&self, step: f64) -> PyResult<ModelOfRun<'_>> {
        ModelOfRun::new(&self.system, self.terms.as_ref(), step)
    }

    /// Checks that a formula of the system, or the function of an event, names each of the inputs, which would do nothing otherwise.
    pub(crate) fn require_named_inputs(&self, events: &[EventArgument]) -> PyResult<()> {
        require_named(&self.idle, events.iter().map(|(function, ..)| function))
    }

    /// Returns what is done along the run of a setting.
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
        let algebra = self.system.algebra();
        let method = || -> Result<Method, FormulaSystemError> {
            let formulation = match formulation {
                Some(name) => name.parse().map_err(MethodError::from)?,
                None => match &self.terms {
                    Some(terms) if terms.torque.is_some() => Formulation::Direct,
                    _ => algebra.default_formulation(),
                },
            };
            let scheme = scheme.parse().map_err(MethodError::from)?;
            match self.model(unit_of(self.terms.as_ref())) {
                Ok(ModelOfRun::Open(open)) => open.method(formulation, scheme, tolerance),
                _ => algebra.method(formulation, scheme, tolerance),
            }
        };
        method().map_err(refused)
    }

    /// Returns a function of each state, as rows.
    fn each<'py>(
        &self,
        py: Python<'py>,
        states: &PyReadonlyArray2<'py, f64>,
        width: usize,
        function: impl Fn(usize, &[f64]) -> PyResult<Vec<f64>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let mut values = Vec::with_capacity(states.len());
        for (i, state) in states.as_array().outer_iter().enumerate() {
            values.extend(function(i, &state.to_vec())?);
        }
        rows(py, values, [states.as_array().nrows(), width])
    }
}
