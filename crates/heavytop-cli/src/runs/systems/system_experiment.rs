//! A run of a Lie–Poisson system, row by row.

use crate::Error;
use crate::runs::moment::{Coordinates, Saved};
use crate::runs::pace::Pace;
use crate::runs::run_check::RunCheck;
use crate::runs::schedule::Schedule;
use crate::runs::visited_samples::visit_samples;
use collective_integrators::Start;
use collective_integrators::diagnostics::RunAccuracy;
use lie_poisson::Vector;
use lie_poisson_formula_systems::{FormulaSystem, SystemMethod, SystemTask};

/// A Lie–Poisson system, its initial state, and the method and steps of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemExperiment {
    /// The system that is followed.
    pub system: FormulaSystem,
    /// The coordinates of the initial state.
    pub start: Vec<f64>,
    /// The integrator of the run.
    pub method: SystemMethod,
    /// The steps of the run, and which of them are written.
    pub pace: Pace,
}

/// A moment of a run: the step, and the row with the time, the coordinates, h and the Casimirs.
#[derive(Clone, Copy)]
pub struct SystemMoment<'a> {
    /// The number of steps made.
    pub step: u64,
    /// The numbers of the row.
    pub row: &'a [f64],
    state: &'a dyn Coordinates,
}

impl SystemMoment<'_> {
    /// Returns the data from which the run continues after this moment.
    #[must_use]
    pub fn saved(&self) -> Saved {
        Saved { step: self.step, state: self.state.coordinates() }
    }
}

impl SystemExperiment {
    /// Returns the number of coordinates of the state that the integrator advances.
    ///
    /// # Errors
    /// If there is no such integrator.
    pub fn dimension(&self) -> Result<usize, Error> {
        Ok(self.method.integrate(&self.system, &self.start, Dimension)?)
    }

    /// Passes the rows of the run to `visit`, from the initial one or from the first after a saved one: those that are
    /// written, those of a step whose number is a multiple of [`CHECKPOINT`](collective_integrators::CHECKPOINT), and the
    /// last one.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, `visit` fails, or the saved state does not fit.
    pub fn follow<V>(&self, from: Option<&Saved>, mut visit: V) -> Result<(), Error>
    where
        V: FnMut(&SystemMoment<'_>) -> Result<(), Error>,
    {
        let task = Follow { experiment: self, from, visit: &mut visit };
        self.method.integrate(&self.system, &self.start, task)?
    }

    /// Measures how accurate the run is, by a repetition of its beginning with half the step. There is no estimate if
    /// `going` tells it to end.
    ///
    /// # Errors
    /// If there is no such integrator.
    pub fn accuracy(&self, going: &dyn Fn() -> bool) -> Result<RunAccuracy, Error> {
        let Schedule { step, steps } = self.pace.schedule;
        Ok(self.method.accuracy(&self.system, &self.start, (step, steps), going)?)
    }

    /// Checks the whole run by runs with half the step and with twice the step, unless `going` tells the check to end.
    ///
    /// # Errors
    /// If a step fails.
    pub fn check(&self, going: &dyn Fn() -> bool) -> Result<RunCheck, Error> {
        let (Schedule { step, steps }, method) = (self.pace.schedule, self.method);
        let checked = method.check(&self.system, &self.start, (step, steps), going)?;
        RunCheck::of(checked, (method.formulation(), method.scheme()))
    }

    /// Returns the initial values of h and of the Casimirs.
    ///
    /// # Errors
    /// If the initial state does not fit the system.
    pub fn initial_invariants(&self) -> Result<Vec<f64>, Error> {
        Ok(self.system.invariants(&self.start)?)
    }

    /// Replaces `row` by the row of a momentum.
    fn fill<M>(&self, row: &mut Vec<f64>, time: f64, mu: &M) -> Result<(), Error>
    where
        M: Vector<Scalar = f64>,
    {
        row.clear();
        row.push(time);
        row.extend((0..self.start.len()).map(|i| mu.coordinate(i)));
        let invariants = self.system.invariants(row.get(1..).unwrap_or_default());
        let invariants = invariants.map_err(|source| Error::NoValue {
            start: None,
            time,
            source: Box::new(source),
        })?;
        row.extend(invariants);
        Ok(())
    }
}

/// The task of counting the coordinates of a state.
struct Dimension;

impl SystemTask for Dimension {
    type Output = usize;

    fn perform<I>(self, _: &I) -> usize
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        I::State::DIM
    }
}

/// A function of the moments of a run. As a trait object, so that the integrators are compiled once for all of them.
type Visit<'a> = &'a mut dyn FnMut(&SystemMoment<'_>) -> Result<(), Error>;

/// The task of following an experiment.
struct Follow<'a> {
    experiment: &'a SystemExperiment,
    from: Option<&'a Saved>,
    visit: Visit<'a>,
}

impl SystemTask for Follow<'_> {
    type Output = Result<(), Error>;

    fn perform<I>(self, integrator: &I) -> Result<(), Error>
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        let SystemExperiment { start, method, pace, .. } = self.experiment;
        let start = I::Momentum::from_coordinates(|i| start.get(i).copied().unwrap_or(0.0));
        let names = (method.formulation(), method.scheme());
        let mut row = Vec::new();
        visit_samples(
            integrator,
            &start,
            (*pace, self.from),
            names,
            |step, time, momentum, state| {
                self.experiment.fill(&mut row, time, momentum)?;
                (self.visit)(&SystemMoment { step, row: &row, state })
            },
        )
    }
}
