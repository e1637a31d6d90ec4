//! A Lie–Poisson system as a Python class.

use super::algebra::{
    AlgebraSource, Groups, ParameterArgument, Realisation, groups, parameters, realised,
};
use crate::arrays::rows;
use crate::errors::refused;
use crate::formulas::{FormulaSource, expressions};
use crate::recorded::Recorded;
use crate::runs::accuracy::{Accuracy, Check};
use crate::runs::event::{Event, EventArgument};
use crate::runs::following::{Following, MethodArgument, Setting};
use crate::runs::interruption::until_interrupted;
use collective_integrators::diagnostics::SystemScales;
use core::sync::atomic::Ordering;
use heavytop::methods::{Method, MethodError};
use lie_poisson_formula_systems::{FormulaSystem, FormulaSystemError, SystemKind, Verdict};
use lie_poisson_formulas::Vocabulary;
use lie_poisson_runs::Model;
use numpy::{PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::types::{PyAnyMethods, PyType};
use pyo3::{Bound, PyResult, Python, pyclass, pymethods};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// A Lie–Poisson system: an algebra, a Hamiltonian, and the Casimirs that were found.
#[pyclass(frozen, module = "heavytop._native")]
pub struct System {
    pub(crate) system: FormulaSystem,
    names: Vocabulary,
    source: Source,
}

/// The arguments from which a system is made; a system by name has no Hamiltonian of its own.
type Source =
    (AlgebraSource, Option<FormulaSource>, Vec<ParameterArgument>, bool, Option<Realisation>);

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
    ) -> PyResult<Self> {
        let given = parameters(&arguments)?;
        let system = match (&algebra, &hamiltonian) {
            (AlgebraSource::OfKind((name,)), None) => {
                let kind = SystemKind::named(name).map_err(refused)?;
                py.detach(|| kind.system(&given)).map_err(refused)?
            }
            (_, Some(hamiltonian)) => {
                let named = algebra.algebra(&given)?;
                let named = match &realisation {
                    Some(realisation) => realised(named, realisation)?,
                    None => named,
                };
                let names = named.vocabulary(&given).map_err(refused)?;
                // A formula that is refused is refused here, with its text.
                hamiltonian.formula(&names)?;
                let system = match hamiltonian {
                    FormulaSource::Text(text) => FormulaSystem::new(named, text, &given),
                    FormulaSource::Traced(parts) => {
                        let (parts, value) = expressions(parts, names.coordinates())?;
                        FormulaSystem::of_expressions(named, &parts, value, &given)
                    }
                };
                let system = match has_plus_bracket {
                    true => system.and_then(FormulaSystem::with_plus_bracket),
                    false => system,
                };
                let find = || system.and_then(FormulaSystem::with_found_casimirs);
                py.detach(find).map_err(refused)?
            }
            _ => return Err(PyValueError::new_err("write a Hamiltonian, or the name of a system")),
        };
        // What the user has given has names in events, too.
        let names = system.algebra().vocabulary(&given).map_err(refused)?;
        let source = (algebra, hamiltonian, arguments, has_plus_bracket, realisation);
        Ok(Self { system, names, source })
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

    /// The formulations that the algebra has, the default one first.
    #[getter]
    fn formulations(&self) -> Vec<String> {
        let algebra = self.system.algebra();
        let first = algebra.default_formulation();
        let others = algebra.formulations().filter(|other| *other != first);
        core::iter::once(first).chain(others).map(|f| f.name().to_owned()).collect()
    }

    /// What the realisation obeys along which collective steps go, if it is one by matrices: whether its bracket is the plus
    /// bracket, the defect of the brackets, the rank, and the defect of the odd powers.
    #[getter]
    fn verdict(&self) -> Option<(bool, f64, usize, f64)> {
        let verdict = self.system.algebra().verdict()?;
        let Verdict { is_plus, defect, rank, odd_powers } = verdict;
        Some((is_plus, defect, rank, odd_powers))
    }

    /// Returns h and the Casimirs of each of n states, as n rows.
    fn invariant_values<'py>(
        &self,
        py: Python<'py>,
        states: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.each(py, &states, 1 + self.system.casimirs().len(), FormulaSystem::invariants)
    }

    /// Returns the rate of each of n states, as n rows.
    fn rates<'py>(
        &self,
        py: Python<'py>,
        states: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.each(py, &states, self.system.algebra().dimension(), FormulaSystem::rate)
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
        let events = Event::all(&events, &self.names, None)?;
        let run = self.following(&setting)?;
        self.system.invariants(&setting.0).map_err(refused)?;
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

impl System {
    /// Returns what is done along the run of a setting.
    fn following(&self, (start, step, method): &Setting) -> PyResult<Following<'_>> {
        Following::new(&self.system, self.method(method.clone())?, (start, *step))
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
                None => algebra.default_formulation(),
            };
            let scheme = scheme.parse().map_err(MethodError::from)?;
            algebra.method(formulation, scheme, tolerance)
        };
        method().map_err(refused)
    }

    /// Returns a function of each state, as rows.
    fn each<'py>(
        &self,
        py: Python<'py>,
        states: &PyReadonlyArray2<'py, f64>,
        width: usize,
        function: impl Fn(&FormulaSystem, &[f64]) -> Result<Vec<f64>, FormulaSystemError>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let mut values = Vec::with_capacity(states.len());
        for state in states.as_array().outer_iter() {
            values.extend(function(&self.system, &state.to_vec()).map_err(refused)?);
        }
        rows(py, values, [states.as_array().nrows(), width])
    }
}
