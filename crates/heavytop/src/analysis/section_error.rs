//! Errors of Poincaré sections.

use crate::tops::coordinate::Coordinate;
use thiserror::Error;

/// The reason why a Poincaré section does not exist.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SectionError {
    /// A number is infinite or not a number.
    #[error("{name} must be a finite number, got {value:?}")]
    NotFinite {
        /// The name of the parameter.
        name: &'static str,
        /// The value of the parameter.
        value: f64,
    },
    /// The level of a component of the unit vector Γ is not between −1 and 1, or is one of these two numbers.
    #[error("the level of {coordinate} must be more than -1 and less than 1, got {level:?}")]
    NoSuchVertical {
        /// The component of the vertical.
        coordinate: Coordinate,
        /// The value of the component.
        level: f64,
    },
    /// The top is a thin rod, whose states over a point of the plane are no two-dimensional family.
    #[error(
        "a thin rod has no section, its motion being that of a spherical pendulum; give it a moment about its axis"
    )]
    ThinRod,
    /// No state on the surface has the energy.
    #[error("no state of the section has an energy of {energy:?} J: the least is {least:?} J")]
    Empty {
        /// The energy of the level, J.
        energy: f64,
        /// The least energy on the surface, J.
        least: f64,
    },
    /// The accessible part of the plane is too small.
    #[error(
        "the section is too small: of {candidates} points in the plane {found} are accessible, {count} \
         are needed; raise the energy"
    )]
    TooSmall {
        /// The number of states asked for.
        count: usize,
        /// The number of states found.
        found: usize,
        /// The number of points tried.
        candidates: u64,
    },
}
