//! The orbit of one start: its points on the section.

use crate::commands::section::settings::Settings;
use crate::errors::Error;
use crate::supervision::TileOptions;
use crate::supervision::tiled_run::interrupted;

/// A point of a Poincaré section.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::section) struct Crossing {
    /// The time of the crossing, s; 0 for a start that is one.
    pub time: f64,
    /// The coordinates of the state at the crossing.
    pub state: Vec<f64>,
    /// The coordinates (x, y) in the plane of the section.
    pub plane: [f64; 2],
}

/// The first point of an orbit, which may be its start, and its returns to the section.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::section) struct Orbit {
    /// The number of the start, from 1.
    pub number: usize,
    /// The points of the orbit.
    pub crossings: Vec<Crossing>,
}

/// Follows a start, and returns its orbit, with the error if it could not be followed to the end.
///
/// Starts are independent of each other, so that no bit depends on the number of threads.
pub(in crate::commands::section) fn orbit(
    settings: &Settings,
    options: &TileOptions<'_>,
    number: usize,
    start: &[f64],
) -> (Orbit, Option<Error>) {
    let problem = &settings.problem;
    let crossing = |time: f64, state: &[f64]| Crossing {
        time,
        state: state.to_vec(),
        plane: problem.plane(time, state),
    };
    let mut crossings = Vec::new();
    if problem.starts_on_surface() {
        crossings.push(crossing(0.0, start));
    }
    let mut visit = |time: f64, state: &[f64]| {
        if options.stopped() {
            return Err(interrupted());
        }
        crossings.push(crossing(time, state));
        Ok(())
    };
    let failure = problem.follow(&settings.limits, number, start, &mut visit).err();
    let longest = settings.limits.longest;
    let never = crossings.is_empty().then_some(Error::NeverCrosses { state: number, longest });
    let failure = failure.or(never);
    (Orbit { number, crossings }, failure)
}
