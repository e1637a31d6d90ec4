//! The family that a sweep follows, of either kind.

use super::course::Course;
use super::family::Family;
use super::system_family::SystemFamily;
use super::top_family::TopFamily;
use crate::Error;
use collective_integrators::diagnostics::RunAccuracy;

/// A family of tops, or of motions of another Lie–Poisson system.
///
/// Only what follows the members needs the integrators: a [`Family`] does not, and the tests of pictures compile without
/// them.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::sweep) enum AnyFamily {
    Tops(TopFamily),
    System(SystemFamily),
}

impl AnyFamily {
    /// Returns what the sweep tells of the family.
    pub fn as_family(&self) -> &dyn Family {
        match self {
            Self::Tops(family) => family,
            Self::System(family) => family,
        }
    }

    /// Follows the member at these values of the axes, and returns the values of the columns of all observables.
    ///
    /// # Errors
    /// If there is no such member, or it cannot be followed to the end.
    pub fn measure(&self, values: &[f64], course: &Course) -> Result<Vec<Option<f64>>, Error> {
        match self {
            Self::Tops(family) => family.measure(values, course),
            Self::System(family) => family.measure(values, course),
        }
    }

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
        match self {
            Self::Tops(family) => family.accuracy(values, course, going),
            Self::System(family) => family.accuracy(values, course, going),
        }
    }
}
