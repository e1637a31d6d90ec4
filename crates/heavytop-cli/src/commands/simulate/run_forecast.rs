//! The forecast of a run: how much it would write, and how long that would take.

use crate::Error;
use crate::configuration::Config;
use crate::files::Place;
use crate::formats::{Format, RunTable};
use crate::runs::Pace;
use crate::supervision::Forecast;
use crate::supervision::forecast::{BYTES_OF_TEXT, TRIAL, compressed};
use std::path::Path;
use std::time::Instant;

/// Returns the forecast of a run without trying it.
///
/// # Errors
/// If there is no such run, or the output has no format.
pub fn forecast(config: &Config, out: &Path) -> Result<Forecast, Error> {
    let run = config.run()?;
    let width = RunTable::new(&*run)?.width() as u64;
    let format = Format::of(out)?;
    let row = if format == Format::Csv { BYTES_OF_TEXT * width } else { 8 * width };
    with_rows(run.pace, format, out, row as f64)
}

/// Returns the forecast of a run after trying it for a fifth of a second, or a little longer if steps are slow. Nothing
/// is written.
///
/// # Errors
/// If there is no such run, the output has no format, or one of the first steps fails.
pub fn dry_run(config: &Config, out: &Path) -> Result<Forecast, Error> {
    let (format, run) = (Format::of(out)?, config.run()?);
    RunTable::new(&*run)?;
    let mut trial = Trial::begin(format);
    let outcome = run.follow(None, |moment| trial.add(moment.step, moment.row));
    trial.end(outcome)?;
    let pace = run.pace;
    let forecast = with_rows(pace, format, out, trial.bytes as f64 / trial.rows as f64)?;
    let steps = pace.schedule.steps as f64;
    Ok(Forecast { seconds: Some(trial.seconds / trial.steps as f64 * steps), ..forecast })
}

/// Returns the forecast for rows of a size. The formats that are made of the rows at the end need twice the room.
fn with_rows(pace: Pace, format: Format, out: &Path, row: f64) -> Result<Forecast, Error> {
    let (steps, rows, place) = (pace.schedule.steps, pace.rows(), Place::of(out)?);
    let rows_of_run = (rows as f64 * row) as u64;
    let (bytes, room) = match format {
        Format::Csv => (rows_of_run, rows_of_run),
        Format::Npz => (rows_of_run, rows_of_run.saturating_mul(2)),
        Format::Parquet => {
            let bytes = compressed(rows_of_run);
            (bytes, rows_of_run.saturating_add(bytes))
        }
    };
    Ok(Forecast {
        out: out.into(),
        work: format!("{steps} steps, {rows} rows"),
        remedy: "raise [output] every, lower the end",
        steps: Some(steps),
        rows,
        bytes,
        room: if place.is_device { 0 } else { room },
        seconds: None,
        is_device: place.is_device,
    })
}

/// The beginning of a run.
struct Trial {
    format: Format,
    encoded: Vec<u8>,
    begun: Instant,
    steps: u64,
    rows: u64,
    bytes: u64,
    seconds: f64,
}

impl Trial {
    fn begin(format: Format) -> Self {
        let (begun, encoded) = (Instant::now(), Vec::new());
        Self { format, encoded, begun, steps: 1, rows: 0, bytes: 0, seconds: 0.0 }
    }

    /// Counts a row after a step, and ends the trial when it has taken its time.
    fn add(&mut self, step: u64, row: &[f64]) -> Result<(), Error> {
        self.encoded.clear();
        self.format.append(row, &mut self.encoded);
        self.rows += 1;
        self.bytes += self.encoded.len() as u64;
        self.steps = step.max(1);
        match self.begun.elapsed() > TRIAL {
            true => Err(Error::Interrupted { resume: None }),
            false => Ok(()),
        }
    }

    fn end(&mut self, outcome: Result<(), Error>) -> Result<(), Error> {
        self.seconds = self.begun.elapsed().as_secs_f64();
        match outcome {
            Ok(()) | Err(Error::Interrupted { .. }) => Ok(()),
            Err(failure) => Err(failure),
        }
    }
}
