//! The interface of the families of motions that sweeps follow.

use super::course::Course;
use crate::configuration::{Column, Integration, Observable, SweepAxis};
use crate::errors::{Error, SweepError};
use crate::pictures::symbols::symbol;
use crate::runs::Schedule;
use collective_integrators::diagnostics::RunAccuracy;
use heavytop::methods::{Formulation, Method};
use lie_poisson_runs::Model;
use std::fmt::Debug;

/// A family of motions, whose members differ by the values of the axes of a sweep.
pub(in crate::commands::sweep) trait Family:
    Debug + Send + Sync
{
    /// Returns the word for a member, and that for several.
    fn nouns(&self) -> [&'static str; 2];

    /// Returns the method by which the members are followed.
    fn method(&self) -> &Method;

    /// Returns the member at these values of the axes, and its start.
    ///
    /// # Errors
    /// If there is no such member, or its motion turns too far in a step (s).
    fn member(&self, values: &[f64], step: f64) -> Result<(Box<dyn Model>, Vec<f64>), Error>;

    /// Returns the fastest rate of the motion of the member at these values of the axes, 1/s.
    ///
    /// # Errors
    /// If there is no such member.
    fn fastest_rate(&self, values: &[f64]) -> Result<f64, Error> {
        let (model, start) = self.member(values, 0.0)?;
        Ok(model.fastest_rate(&start))
    }

    /// Returns warnings for users: about what the method does not conserve, and about the body.
    fn warnings(&self) -> Vec<String>;

    /// Returns a warning about the accuracy of the worst member, without the word.
    fn accuracy_warning(&self, accuracy: &RunAccuracy) -> Option<String> {
        accuracy.warning()
    }

    /// Returns whether members may be impossible although their motions can be computed.
    fn judges_members(&self) -> bool {
        false
    }

    /// Returns the reason why the member at these values of the axes is impossible.
    fn impossibility(&self, _values: &[f64]) -> Option<String> {
        None
    }

    /// Returns the columns of an observable.
    ///
    /// # Errors
    /// If the members do not have the observable.
    fn columns(&self, observable: Observable) -> Result<Vec<Column>, SweepError>;

    /// Returns the symbol of the number that each axis varies, with its unit.
    fn labels(&self) -> Vec<String>;

    /// Returns the numbers that the axes have in the member that is run at these values of the axes.
    fn run_values(&self, values: &[f64]) -> Vec<f64> {
        values.to_vec()
    }

    /// Returns what all members share, as parts of a caption.
    fn shared(&self) -> Vec<String>;

    /// Returns the Casimirs that the table numbers, as formulas; none where those of the members differ.
    fn casimirs(&self) -> Vec<String>;

    /// Follows the member at these values of the axes, and returns the values of the columns of all observables.
    ///
    /// # Errors
    /// If there is no such member, or it cannot be followed to the end.
    fn measure(&self, values: &[f64], course: &Course) -> Result<Vec<Option<f64>>, Error>;
}

impl dyn Family + '_ {
    /// Measures how accurate the motion of the member at these values of the axes is.
    ///
    /// # Errors
    /// If there is no such member.
    pub fn accuracy(
        &self,
        values: &[f64],
        course: &Course,
        going: &dyn Fn() -> bool,
    ) -> Result<RunAccuracy, Error> {
        let Schedule { step, steps } = course.schedule;
        let (model, start) = self.member(values, step)?;
        Ok(model.accuracy(self.method(), &start, (step, steps), going)?)
    }
}

/// Returns a column for the largest deviation of each of these quantities.
pub(super) fn drift_columns(names: impl IntoIterator<Item = String>) -> Vec<Column> {
    let column = |name: String| {
        Column::logarithmic(&format!("drift_{name}"), &format!("deviation of {}", symbol(&name)))
    };
    names.into_iter().map(column).collect()
}

/// Returns a column for each of these coordinates at the end.
pub(super) fn end_columns(names: impl IntoIterator<Item = String>) -> Vec<Column> {
    let column = |name: String| Column::linear(&name, &format!("{} at the end", symbol(&name)));
    names.into_iter().map(column).collect()
}

/// Returns the columns of an observable that has the same ones for every system.
///
/// # Errors
/// [`SweepError::OfTops`] if it is none of those that a family has.
pub(super) fn shared_columns(
    observable: Observable,
    observables: &[Observable],
) -> Result<Vec<Column>, SweepError> {
    if observables.contains(&observable) {
        return Ok(observable.columns());
    }
    let has = observables.iter().copied().map(Observable::name).collect();
    Err(SweepError::OfTops { observable: observable.name(), has })
}

/// Returns the integrator of a sweep whose `[integrator]` is empty.
pub(super) fn own_integration(formulation: Formulation) -> Integration {
    Integration { formulation, step: 0.1, ..Integration::default() }
}

/// Checks that no two axes set the same number, where `clashes` tells of two numbers whether they do.
///
/// # Errors
/// [`SweepError::Clash`] if there are two such axes.
pub(super) fn require_apart<T>(
    axes: &[SweepAxis],
    numbers: &[T],
    clashes: impl Fn(&T, &T) -> bool,
) -> Result<(), SweepError> {
    for (n, (axis, number)) in axes.iter().zip(numbers).enumerate() {
        let mut before = axes.iter().zip(numbers).take(n);
        if let Some((other, _)) = before.find(|(_, other)| clashes(other, number)) {
            let (first, second) = (other.parameter.name(), axis.parameter.name());
            return Err(SweepError::Clash { first, second });
        }
    }
    Ok(())
}
