//! The accuracy of some of the orbits of a section.

use super::orbit::Orbit;
use super::orbit_tiles::Orbits;
use crate::commands::section::settings::Settings;
use crate::errors::Error;
use crate::runs::run_check::worse;
use collective_integrators::diagnostics::RunAccuracy;
use rayon::prelude::*;

/// The largest number of orbits that are measured.
const MOST: u64 = 8;

/// The accuracy of the orbits that were measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::commands::section) struct OrbitAccuracy {
    /// The largest angle of a step and the largest error.
    pub worst: RunAccuracy,
    /// The least error.
    pub least: Option<f64>,
    /// The number of orbits that were measured.
    pub measured: usize,
}

/// Measures some of the orbits, spread over the starts, each over the time for which it was followed, unless `going` tells
/// it to end.
///
/// # Errors
/// If a tile is missing.
pub(in crate::commands::section) fn orbit_accuracy(
    settings: &Settings,
    orbits: &Orbits<'_>,
    going: &(dyn Fn() -> bool + Sync),
) -> Result<Option<OrbitAccuracy>, Error> {
    let starts = settings.limits.starts as u64;
    let count = MOST.min(starts);
    let measured = (0..count).into_par_iter().map(|number| {
        let number = (number * starts / count) as usize;
        let (orbit, start) = (orbits.orbit(number)?, orbits.start(number));
        let both = orbit.as_ref().zip(start);
        Ok(both.and_then(|(orbit, start)| of_orbit(settings, (orbit, start), going)))
    });
    let measured: Vec<Option<RunAccuracy>> = measured.collect::<Result<_, Error>>()?;
    let measured: Vec<RunAccuracy> = measured.into_iter().flatten().collect();
    let least = measured.iter().filter_map(|accuracy| accuracy.error).reduce(f64::min);
    let worst = measured.iter().copied().reduce(worse);
    Ok(worst.map(|worst| OrbitAccuracy { worst, least, measured: measured.len() }))
}

/// Measures an orbit up to its last return. One without a return was followed as long as all could be.
fn of_orbit(
    settings: &Settings,
    (orbit, start): (&Orbit, &[f64]),
    going: &(dyn Fn() -> bool + Sync),
) -> Option<RunAccuracy> {
    let limits = &settings.limits;
    let is_short = orbit.crossings.len() <= limits.crossings;
    let last = orbit.crossings.last().map_or(0.0, |crossing| crossing.time);
    let steps = if is_short { limits.steps as u64 } else { (last / limits.step).ceil() as u64 };
    settings.problem.accuracy(start, (limits.step, steps), &|| going()).ok()
}
