//! Sections that are empty.

use crate::Coordinate;
use thiserror::Error;

/// Why there is no Poincaré section.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SectionError {
    /// A number is infinite or not a number.
    #[error("{name} must be a finite number, got {value:?}")]
    NotFinite {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The vertical has no such component, or only where it is along the axis.
    #[error("the level of {coordinate} must be more than -1 and less than 1, got {level:?}")]
    NoSuchVertical {
        /// The component.
        coordinate: Coordinate,
        /// Its value.
        level: f64,
    },
    /// No state on the surface has the energy.
    #[error("no state of the section has an energy of {energy:?} J: the least is {least:?} J")]
    Empty {
        /// The energy, J.
        energy: f64,
        /// The least energy on the surface, J.
        least: f64,
    },
    /// The accessible part is too small to be hit.
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
