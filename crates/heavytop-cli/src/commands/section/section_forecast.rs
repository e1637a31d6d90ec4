//! The forecast of a section: how much it would write, and how long that would take.

use super::orbits::orbit::orbit;
use super::problems::limits::Limits;
use super::settings::Settings;
use crate::Error;
use crate::configuration::Config;
use crate::supervision::forecast::{BYTES_OF_TEXT, TRIAL, compressed, spread};
use crate::supervision::tiled_run::threads;
use crate::supervision::{Forecast, TileOptions};
use rayon::prelude::*;
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
    let text = rows * BYTES_OF_TEXT * (numbers - 2);
    let table = compressed(rows * 8 * numbers);
    let bytes = text + table + rows * BYTES_OF_DRAWING + BYTES_OF_FRAMES;
    Forecast {
        out: out.into(),
        work: format!("{starts} starts, at most {rows} points"),
        remedy: "lower starts or crossings",
        steps: None,
        rows,
        bytes,
        // Until the tables are complete there are the tiles besides them.
        room: bytes + text,
        seconds: None,
        is_device: false,
    }
}

/// Follows some of the starts for some returns, and returns the time that all would take, s.
fn seconds(settings: &Settings, starts: &[Vec<f64>]) -> Result<f64, Error> {
    let all = settings.limits;
    let (steps, crossings) = (all.steps.min(MOST_STEPS), all.crossings.min(MOST_RETURNS));
    let problem = settings.problem.clone();
    let shortened = Settings { problem, limits: Limits { steps, crossings, ..all } };
    let threads = rayon::current_num_threads();
    let (begun, mut followed, mut sum) = (Instant::now(), 0, 0.0);
    while followed == 0 || begun.elapsed() < TRIAL {
        let group = (followed..followed + threads).into_par_iter().map(|n| {
            let number = spread(n as u64, starts.len() as u64) as usize;
            of_start(&all, &shortened, number, starts.get(number))
        });
        sum += group.try_reduce(|| 0.0, |a, b| Ok(a + b))?;
        followed += threads;
    }
    Ok(sum / followed as f64 * all.starts as f64 / threads.min(all.starts) as f64)
}

/// Returns the time that a start would take on one thread, s.
fn of_start(
    all: &Limits,
    shortened: &Settings,
    number: usize,
    start: Option<&Vec<f64>>,
) -> Result<f64, Error> {
    let Some(start) = start else { return Ok(0.0) };
    let begun = Instant::now();
    let (orbit, failure) = orbit(shortened, &TileOptions::default(), number + 1, start);
    if let Some(failure) = failure {
        return Err(failure);
    }
    let seconds = begun.elapsed().as_secs_f64();
    let returns = orbit.crossings.len().saturating_sub(1);
    let last = orbit.crossings.last().map_or(0.0, |crossing| crossing.time);
    Ok(seconds * multiple(all, &shortened.limits, returns, last))
}

/// Returns how many times as long a start takes as its trial, which ended after some returns, the last one at this time
/// (s), or after all its steps.
fn multiple(all: &Limits, shortened: &Limits, returns: usize, last: f64) -> f64 {
    let of_returns = all.crossings as f64 / returns as f64;
    let of_time = if returns < shortened.crossings {
        all.steps as f64 / shortened.steps as f64
    } else {
        all.longest / last.abs()
    };
    of_returns.min(of_time)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_start_ends_after_its_returns_or_its_time() {
        let limits = Settings::of(&Config::default()).unwrap().limits;
        let all = Limits { crossings: 500, longest: 1e4, steps: 100_000, ..limits };
        let few = Limits { crossings: 8, steps: 10_000, ..all };
        // Eight returns in 20 s: 500 take 1250 s, and with 1e5 of them the time ends first.
        assert_eq!(multiple(&all, &few, 8, 20.0), 62.5);
        assert_eq!(multiple(&Limits { crossings: 100_000, ..all }, &few, 8, 20.0), 500.0);
        // The trial ended after its steps, with some returns or none.
        assert_eq!(multiple(&all, &few, 5, 700.0), 10.0);
        assert_eq!(multiple(&Limits { crossings: 8, ..all }, &few, 4, 700.0), 2.0);
        assert_eq!(multiple(&all, &few, 0, 0.0), 10.0);
    }
}
