//! The motion of which a section is made, of either kind.

use super::limits::Limits;
use super::section_problem::{SectionProblem, Visit};
use super::system_problem::SystemProblem;
use super::top_problem::TopProblem;
use crate::Error;
use collective_integrators::diagnostics::RunAccuracy;

/// The motion of a top, or of another Lie–Poisson system.
///
/// Only what follows the starts needs the integrators: a [`SectionProblem`] does not, and the tests of pictures compile without
/// them.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::section) enum AnyProblem {
    Top(TopProblem),
    System(SystemProblem),
}

impl AnyProblem {
    /// Returns what the section tells of the motion.
    pub fn as_problem(&self) -> &dyn SectionProblem {
        match self {
            Self::Top(problem) => problem,
            Self::System(problem) => problem,
        }
    }

    /// Finds the starts of the section.
    ///
    /// # Errors
    /// If there are none, or a given state never comes to the surface.
    pub fn starts(&self, limits: &Limits) -> Result<Vec<Vec<f64>>, Error> {
        match self {
            Self::Top(problem) => problem.starts(limits),
            Self::System(problem) => problem.starts(limits),
        }
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
        match self {
            Self::Top(problem) => problem.accuracy(start, steps, going),
            Self::System(problem) => problem.accuracy(start, steps, going),
        }
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
        match self {
            Self::Top(problem) => problem.follow(limits, number, start, visit),
            Self::System(problem) => problem.follow(limits, number, start, visit),
        }
    }
}
