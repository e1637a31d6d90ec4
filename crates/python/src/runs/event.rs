//! Functions of the state and the time whose zeros are found along a run: [`Event`].

use crate::errors::{IntegrationError, failed, message};
use crate::formulas::FormulaSource;
use collective_integrators::{Direction, EventError, EventSearch};
use lie_poisson::Pair;
use lie_poisson_formulas::Vocabulary;
use lie_poisson_runs::{Model, TimedIntegrator, TimedState};
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::{Py, PyAny, PyErr, PyResult, Python};
use std::sync::{Arc, Mutex};

/// An event as Python passes it: the function, the direction 1, −1 or 0, and after how many occurrences the run ends.
pub(crate) type EventArgument = (FormulaSource, i8, u64);

/// A function of the arrays of a system and the time as Python passes it, with the direction and the number of the last occurrence.
pub(crate) type CallbackArgument = (Py<PyAny>, i8, u64);

/// A function of a state and the time.
type Function<'a> = Box<dyn Fn(&[f64], f64) -> f64 + Send + Sync + 'a>;

/// A function of the state and the time whose zeros are found.
pub(crate) struct Event<'a> {
    function: Function<'a>,
    /// The period of an angle.
    period: Option<f64>,
    direction: Direction,
    /// The number of occurrences after which the run ends; 0 if it does not.
    pub(crate) last: u64,
    /// The exception that the function has raised.
    raised: Arc<Mutex<Option<PyErr>>>,
}

impl<'a> Event<'a> {
    /// Creates an event in the names of a model, in the axes of the users.
    pub(crate) fn new(
        (function, way, last): &EventArgument,
        names: &Vocabulary,
        model: &'a dyn Model,
    ) -> PyResult<Self> {
        let formula = function.formula(names)?;
        let period = formula.period();
        let function = move |mu: &[f64], time: f64| {
            let mut x = mu.to_vec();
            model.present(&mut x);
            model.append_inputs(time, &mut x);
            formula.value_at(x.get(..formula.dimension()).unwrap_or(&x))
        };
        Self::of(Box::new(function), period, (*way, *last), Arc::default())
    }

    /// Creates several events.
    pub(crate) fn all(
        arguments: &[EventArgument],
        names: &Vocabulary,
        model: &'a dyn Model,
    ) -> PyResult<Vec<Self>> {
        arguments.iter().map(|argument| Self::new(argument, names, model)).collect()
    }

    /// Creates an event of a Python function of the state, as users read it, and the time.
    pub(crate) fn of_callback(
        (callback, way, last): &'a CallbackArgument,
        model: &'a dyn Model,
    ) -> PyResult<Self> {
        let raised: Arc<Mutex<Option<PyErr>>> = Arc::default();
        let keep = Arc::clone(&raised);
        let function = move |mu: &[f64], time: f64| {
            let mut state = mu.to_vec();
            model.present(&mut state);
            let value = Python::attach(|py| {
                callback.call1(py, (PyArray1::from_vec(py, state), time))?.extract::<f64>(py)
            });
            value.unwrap_or_else(|error| {
                if let Ok(mut first) = keep.lock() {
                    first.get_or_insert(error);
                }
                f64::NAN
            })
        };
        Self::of(Box::new(function), None, (*way, *last), raised)
    }

    fn of(
        function: Function<'a>,
        period: Option<f64>,
        (way, last): (i8, u64),
        raised: Arc<Mutex<Option<PyErr>>>,
    ) -> PyResult<Self> {
        Ok(Self { function, period, direction: direction(way)?, last, raised })
    }

    /// Returns the exception that the function has raised, if it has.
    pub(crate) fn raised(&self) -> Option<PyErr> {
        self.raised.lock().ok()?.take()
    }

    /// Returns the search for the event along a run of an integrator.
    pub(crate) fn search<'b>(
        &'b self,
        integrator: &'b TimedIntegrator<'b>,
    ) -> EventSearch<'b, TimedIntegrator<'b>, impl Fn(&TimedState) -> f64 + use<'a, 'b>> {
        let function = |Pair(mu, time): &TimedState| (self.function)(mu.as_slice(), time.0);
        let search = EventSearch::new(integrator, function, self.direction);
        match self.period {
            Some(period) => search.modulo(period),
            None => search,
        }
    }
}

/// Converts the error of the event with this index: `ValueError` where it has no value at the start of the run, and
/// `IntegrationError` where the run fails later.
pub(crate) fn event_failed((index, error): (usize, EventError), is_start: bool) -> PyErr {
    let text = format!("event {index}: {}", message(&error));
    match error {
        EventError::Integration(error) => failed(error),
        _ if is_start => PyValueError::new_err(text),
        _ => IntegrationError::new_err(text),
    }
}

/// Returns the direction 1, −1 or 0.
pub(crate) fn direction(way: i8) -> PyResult<Direction> {
    match way {
        1 => Ok(Direction::Up),
        -1 => Ok(Direction::Down),
        0 => Ok(Direction::Both),
        other => {
            let text = format!("direction must be 1, -1 or 0, got {other}");
            Err(PyValueError::new_err(text))
        }
    }
}
