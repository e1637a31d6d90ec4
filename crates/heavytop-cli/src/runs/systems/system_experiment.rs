//! A run of a Lie–Poisson system, row by row.

use crate::Error;
use crate::runs::moment::Saved;
use crate::runs::pace::Pace;
use crate::runs::run_check::RunCheck;
use crate::runs::schedule::Schedule;
use crate::runs::visited_samples::visit_samples;
use collective_integrators::diagnostics::RunAccuracy;
use collective_integrators::{AnyIntegrator, AnyState};
use lie_poisson_formula_systems::{FormulaSystem, SystemMethod};

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
    state: &'a AnyState,
}

impl SystemMoment<'_> {
    /// Returns the data from which the run continues after this moment.
    #[must_use]
    pub fn saved(&self) -> Saved {
        Saved { step: self.step, state: self.state.as_slice().to_vec() }
    }
}

impl SystemExperiment {
    /// Returns the number of coordinates of the state that the integrator advances.
    ///
    /// # Errors
    /// If there is no such integrator.
    pub fn dimension(&self) -> Result<usize, Error> {
        Ok(self.integrator()?.state_dimension())
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
        let Self { start, method, pace, .. } = self;
        let (integrator, names) = (self.integrator()?, (method.formulation(), method.scheme()));
        let (start, place) = (AnyState::from_slice(start), (*pace, from));
        let mut row = Vec::new();
        visit_samples(&integrator, &start, place, names, |sample| {
            self.fill(&mut row, sample.time, sample.momentum.as_slice())?;
            visit(&SystemMoment { step: sample.step, row: &row, state: &sample.state })
        })
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

    fn integrator(&self) -> Result<AnyIntegrator, Error> {
        Ok(self.method.integrator(&self.system, &self.start)?.without_tangents())
    }

    /// Replaces `row` by the row of a momentum.
    fn fill(&self, row: &mut Vec<f64>, time: f64, mu: &[f64]) -> Result<(), Error> {
        row.clear();
        row.push(time);
        row.extend_from_slice(mu);
        let invariants = self.system.invariants(mu);
        let invariants = invariants.map_err(|source| Error::NoValue {
            start: None,
            time,
            source: Box::new(source),
        })?;
        row.extend(invariants);
        Ok(())
    }
}
