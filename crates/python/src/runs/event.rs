//! Functions of the state whose zeros are found along a run: [`Event`].

use crate::errors::{IntegrationError, failed, message};
use crate::formulas::FormulaSource;
use collective_integrators::{AnyIntegrator, AnyState, Direction, EventError, EventSearch};
use heavytop::PrincipalAxes;
use lie_poisson_formulas::{Formula, Vocabulary};
use lie_poisson_runs::TopInAxes;
use pyo3::exceptions::PyValueError;
use pyo3::{PyErr, PyResult};

/// An event as Python passes it: the function, the direction 1, −1 or 0, and after how many occurrences the run ends.
pub(crate) type EventArgument = (FormulaSource, i8, u64);

/// A function of the state whose zeros are found.
#[derive(Clone)]
pub(crate) struct Event {
    function: Formula,
    direction: Direction,
    /// The principal axes of a top, in the axes of the function's coordinates, where these are others.
    axes: Option<PrincipalAxes>,
    /// The number of occurrences after which the run ends; 0 if it does not.
    pub(crate) last: u64,
}

impl Event {
    /// Creates an event in the names of a space.
    pub(crate) fn new(
        argument: &EventArgument,
        names: &Vocabulary,
        axes: Option<PrincipalAxes>,
    ) -> PyResult<Self> {
        let (function, way, last) = argument;
        let (function, direction) = (function.formula(names)?, direction(*way)?);
        Ok(Self { function, direction, axes, last: *last })
    }

    /// Creates several events.
    pub(crate) fn all(
        arguments: &[EventArgument],
        names: &Vocabulary,
        axes: Option<PrincipalAxes>,
    ) -> PyResult<Vec<Self>> {
        arguments.iter().map(|argument| Self::new(argument, names, axes)).collect()
    }

    /// Returns the search for the event along a run of an integrator.
    pub(crate) fn search<'a>(
        &'a self,
        integrator: &'a AnyIntegrator,
    ) -> EventSearch<'a, AnyIntegrator, impl Fn(&AnyState) -> f64 + use<'a>> {
        let function = |mu: &AnyState| match &self.axes {
            Some(axes) => {
                let given = axes.state_from_principal(&TopInAxes::state(mu.as_slice()));
                self.function.value_at(&TopInAxes::coordinates(&given))
            }
            None => self.function.value_at(mu.as_slice()),
        };
        let search = EventSearch::new(integrator, function, self.direction);
        match self.function.period() {
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
