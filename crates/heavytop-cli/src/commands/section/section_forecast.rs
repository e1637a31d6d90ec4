//! The forecast of a section: how much it would write, and how long that would take.

use super::orbits::orbit::orbit;
use super::problems::limits::Limits;
use super::settings::Settings;
use crate::configuration::Config;
use crate::errors::Error;
use crate::supervision::forecast::{in_parquet, in_text, time_of_all};
use crate::supervision::tiled_run::threads;
use crate::supervision::{Forecast, TileOptions};
use std::path::Path;
use std::time::Instant;

/// The largest number of steps of a start in a trial.
const MOST_STEPS: usize = 10_000;

/// The largest number of returns of a start in a trial.
const MOST_RETURNS: usize = 8;

/// The numbers of a point in a table besides the state: the start, the crossing, the time and the place in the plane.
const NUMBERS: u64 = 5;

/// The bytes of a point in `section.svg`.
const BYTES_OF_DRAWING: u64 = 26;

/// The bytes of both pictures without points; lettering takes most of them.
const BYTES_OF_FRAMES: u64 = 280_000;

/// Returns the forecast of a section without trying it.
///
/// # Errors
/// If there is no such section.
pub fn forecast(config: &Config, out: &Path) -> Result<Forecast, Error> {
    Settings::of(config).map(|settings| of(&settings, out))
}

/// Returns the forecast of a section after trying some of its starts for a fifth of a second, or a little longer if
/// they return rarely. Nothing is written.
///
/// # Errors
/// If there is no such section, its threads cannot be started, or one of the starts cannot be followed.
///
/// # Example
/// ```
/// use heavytop_cli::commands::section::dry_run;
/// use heavytop_cli::configuration::Config;
/// let forecast = dry_run(&Config::default(), "section".as_ref(), Some(1))?;
/// assert_eq!(forecast.rows, 60 * (1 + 500));
/// assert!(forecast.seconds.is_some_and(|seconds| seconds > 0.0));
/// # Ok::<(), heavytop_cli::Error>(())
/// ```
pub fn dry_run(config: &Config, out: &Path, count: Option<usize>) -> Result<Forecast, Error> {
    let (settings, threads) = (Settings::of(config)?, threads(count)?);
    let starts = settings.problem.starts(&settings.limits)?;
    let seconds = threads.install(|| seconds(&settings, &starts))?;
    Ok(Forecast { seconds: Some(seconds), ..of(&settings, out) })
}

fn of(settings: &Settings, out: &Path) -> Forecast {
    let Limits { starts, crossings, .. } = settings.limits;
    let rows = starts as u64 * (1 + crossings as u64);
    let numbers = NUMBERS + settings.problem.columns().len() as u64;
    let text = in_text(rows * (numbers - 2));
    let bytes = text + in_parquet(rows * numbers) + rows * BYTES_OF_DRAWING + BYTES_OF_FRAMES;
    Forecast {
        out: out.into(),
        work: format!("{starts} starts, at most {rows} points"),
        remedy: "lower starts or crossings",
        rows,
        bytes,
        // Until the tables are complete there are the tiles besides them.
        room: bytes + text,
        ..Forecast::default()
    }
}

/// Returns the time that all starts would take, s, estimated from the first returns of some.
fn seconds(settings: &Settings, starts: &[Vec<f64>]) -> Result<f64, Error> {
    let all = settings.limits;
    let (steps, crossings) = (all.steps.min(MOST_STEPS), all.crossings.min(MOST_RETURNS));
    let longest = steps as f64 * all.step.abs();
    let limits = Limits { steps, crossings, longest, ..all };
    let shortened = Settings { limits, ..settings.clone() };
    time_of_all(starts.len() as u64, |number| {
        let Some(start) = starts.get(number as usize) else { return Ok(0.0) };
        let begun = Instant::now();
        let (orbit, failure) =
            orbit(&shortened, &TileOptions::default(), number as usize + 1, start);
        let seconds = begun.elapsed().as_secs_f64();
        let returns = orbit.crossings.len().saturating_sub(1);
        let last = orbit.crossings.last().map_or(0.0, |crossing| crossing.time);
        failure.map_or(Ok(seconds / part(&all, &limits, returns, last)), Err)
    })
}

/// Returns the part of a start, which ends after its returns or its longest time, that was made in a trial: after some
/// returns, the last one at this time (s), or after all the trial's steps.
fn part(all: &Limits, tried: &Limits, returns: usize, last: f64) -> f64 {
    let time = if returns < tried.crossings { tried.longest } else { last.abs() };
    (returns as f64 / all.crossings as f64).max(time / all.longest)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_start_ends_after_its_returns_or_its_time() {
        let limits = Settings::of(&Config::default()).unwrap().limits;
        let all = Limits { crossings: 500, longest: 1e4, steps: 100_000, ..limits };
        let few = Limits { crossings: 8, longest: 1e3, steps: 10_000, ..all };
        // Eight returns in 20 s: 500 take 1250 s, and with 1e5 of them the time ends first.
        assert_eq!(part(&all, &few, 8, 20.0), 8.0 / 500.0);
        assert_eq!(part(&Limits { crossings: 100_000, ..all }, &few, 8, -20.0), 20.0 / 1e4);
        // The trial ended after its steps, with some returns or none.
        assert_eq!(part(&all, &few, 5, 700.0), 0.1);
        assert_eq!(part(&Limits { crossings: 8, ..all }, &few, 4, 700.0), 0.5);
        assert_eq!(part(&all, &few, 0, 0.0), 0.1);
    }
}
