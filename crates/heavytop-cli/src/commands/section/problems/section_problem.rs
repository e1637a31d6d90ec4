//! The interface of the motions that sections are made of: their states as numbers, how they are followed, and how a
//! section is drawn.

use super::limits::Limits;
use crate::configuration::SectionConfig;
use crate::errors::Error;
use collective_integrators::diagnostics::RunAccuracy;
use collective_integrators::{AnyState, Direction, Events, Integrator, RunError, Start};
use heavytop::methods::Method;
use lie_poisson::Pair;
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_runs::{Model, TimedIntegrator, TimedState};
use serde_json::{Map, Value};
use std::fmt::Debug;

/// A function that is called with the time (s) and the state of each return of a trajectory to the surface.
pub(in crate::commands::section) type Visit<'a> =
    &'a mut dyn FnMut(f64, &[f64]) -> Result<(), Error>;

/// A kind of motion that sections are made of: of a top, or of another Lie–Poisson system.
pub(in crate::commands::section) trait SectionProblem:
    Debug + Send + Sync
{
    /// Returns the system that moves.
    fn model(&self) -> &dyn Model;

    /// Returns the method by which the motion is followed.
    fn method(&self) -> &Method;

    /// Returns the direction of the crossings that count, and the period of the surface's function if it is an angle.
    fn surface(&self) -> (Direction, Option<f64>);

    /// Returns the function of the time (s) and the momentum whose zeros are the surface.
    fn value(&self, time: f64, momentum: &[f64]) -> f64;

    /// Returns whether the starts are points of the section; if not, each is followed to its first one.
    fn starts_on_surface(&self) -> bool {
        true
    }

    /// Checks that what is written and drawn of a momentum at a time has a value.
    fn require_values(&self, _time: f64, _momentum: &[f64]) -> Result<(), FormulaSystemError> {
        Ok(())
    }

    /// Returns warnings for users: about what the method does not conserve, and about the body.
    fn warnings(&self) -> Vec<String>;

    /// Checks that the step (s) resolves the motion.
    fn require_step(&self, step: f64) -> Result<(), Error>;

    /// Returns the table `[section]` with every key that was left out and plays a part.
    fn complete(&self, section: SectionConfig) -> SectionConfig;

    /// Returns the place (x, y) at which a state at a time (s) is drawn.
    fn plane(&self, time: f64, state: &[f64]) -> [f64; 2];

    /// Returns the names of the conserved quantities.
    fn conserved(&self) -> Vec<String>;

    /// Returns how much the conserved quantities at a state of an orbit deviate from those of the section.
    fn deviations(&self, start: &[f64], state: &[f64]) -> Vec<f64>;

    /// Returns the level and the surface, on a line.
    fn title(&self) -> String;

    /// Returns what the section is of, and the largest deviations of the conserved quantities, for machines.
    fn summary(&self, deviations: &[f64]) -> Map<String, Value>;

    /// Returns the words of the picture.
    fn drawing(&self, limits: &Limits) -> Drawing;

    /// Finds the starts of the section.
    ///
    /// # Errors
    /// If there are none, or a given state never comes to the surface.
    fn starts(&self, limits: &Limits) -> Result<Vec<Vec<f64>>, Error>;
}

impl dyn SectionProblem + '_ {
    /// Returns the names of the coordinates of a state.
    pub fn columns(&self) -> Vec<String> {
        self.model().columns()
    }

    /// Measures how accurate the motion of a start is for so many steps of a size (s).
    ///
    /// # Errors
    /// If there is no such integrator.
    pub fn accuracy(
        &self,
        start: &[f64],
        steps: (f64, u64),
        going: &dyn Fn() -> bool,
    ) -> Result<RunAccuracy, Error> {
        let model = self.model();
        Ok(model.accuracy(self.method(), &model.start(start)?, steps, going)?)
    }

    /// Passes the returns of a start with this number to `visit`.
    ///
    /// # Errors
    /// If the start cannot be followed, or `visit` fails.
    pub fn follow(
        &self,
        limits: &Limits,
        number: usize,
        start: &[f64],
        visit: Visit<'_>,
    ) -> Result<(), Error> {
        let (later, first) = (self.starts_on_surface(), usize::from(!self.starts_on_surface()));
        let limits = Limits { crossings: limits.crossings + first, ..*limits };
        visit_returns(self, &limits, (number, start, !later), visit)
    }
}

/// Passes the returns of a start with this number to `visit`, which may count the start if it lies on the surface.
///
/// # Errors
/// If the start cannot be followed, or `visit` fails.
pub(super) fn visit_returns(
    problem: &dyn SectionProblem,
    limits: &Limits,
    (number, start, counts_start): (usize, &[f64], bool),
    visit: Visit<'_>,
) -> Result<(), Error> {
    let (model, method) = (problem.model(), problem.method());
    let start = model.start(start)?;
    let integrator = model.integrator(method, &start)?;
    let start = AnyState::from_slice(&start);
    let mut state = integrator.start(&start).map_err(RunError::from)?;
    // Each start has a path of the noise of its own.
    model.move_path(state.as_mut_slice(), number.saturating_sub(1) as u64);
    let samples = integrator.trajectory_from(state, limits.step).through(start);
    let samples = samples.take(limits.steps.saturating_add(1));
    let samples = samples.map(|sample| sample.map(|sample| TimedIntegrator::sample(&sample)));
    let value = |Pair(mu, time): &TimedState| problem.value(time.0, mu.as_slice());
    let (direction, period) = problem.surface();
    let timed = TimedIntegrator::new(&integrator);
    let mut returns = Events::new(&timed, samples, value, direction.along_run(limits.step));
    if let Some(period) = period {
        returns = returns.modulo(period);
    }
    if counts_start {
        returns = returns.counting_start();
    }
    for event in returns.take(limits.crossings) {
        let sample = event.map_err(|source| Error::Crossing {
            formulation: method.formulation().name(),
            scheme: method.scheme().name(),
            start: number,
            source,
        })?;
        let Pair(momentum, _) = sample.momentum;
        let (time, mut state) = (sample.time, momentum.as_slice().to_vec());
        problem.require_values(time, &state).map_err(|source| Error::NoValue {
            start: number,
            time,
            source: Box::new(source),
        })?;
        model.present(&mut state);
        visit(time, &state)?;
    }
    Ok(())
}

/// The words of the picture of a section.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::section) struct Drawing {
    /// The parts of the caption.
    pub caption: Vec<String>,
    /// The title of the abscissa, and whether it is an angle from 0 to 2π.
    pub abscissa: (String, bool),
    /// The symbol of the ordinate, and its unit in parentheses.
    pub ordinate: (String, &'static str),
}
