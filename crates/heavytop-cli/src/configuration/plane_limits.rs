//! The table `limits` of `[section]`: which part of the plane of a section its picture shows.

use crate::errors::Error;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// The part of the plane of a section that its picture shows; an axis that is left out fits the points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PlaneLimits {
    /// The ends of the abscissa, in the unit of x.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x: Option<[f64; 2]>,
    /// The ends of the ordinate, in the unit of y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<[f64; 2]>,
}

impl PlaneLimits {
    /// Checks that there is a range between the ends of each axis, and of an abscissa that is an angle a turn at most.
    ///
    /// # Errors
    /// [`Error::PlaneLimits`] if there is none.
    pub(crate) fn require(&self, is_angle: bool) -> Result<(), Error> {
        let wrong =
            |axis, needs, [from, to]: [f64; 2]| Error::PlaneLimits { axis, needs, from, to };
        for (axis, ends) in [("x", self.x), ("y", self.y)] {
            let Some([from, to]) = ends else { continue };
            if !(from.is_finite() && to.is_finite()) {
                return Err(wrong(axis, "two finite numbers", [from, to]));
            }
            // Halves cannot overflow. Ends that round-off alone tells apart have no room for ticks.
            let size = from.abs().max(to.abs());
            if to / 2.0 - from / 2.0 <= LEAST_SPAN * size {
                return Err(wrong(axis, "two numbers, the second above the first", [from, to]));
            }
            if axis == "x" && is_angle && to - from > TAU * (1.0 + LEAST_SPAN) {
                return Err(wrong(axis, "at most 2π apart, since x is an angle", [from, to]));
            }
        }
        Ok(())
    }
}

/// The least distance of the ends, relative to their size.
const LEAST_SPAN: f64 = 1e-9;
