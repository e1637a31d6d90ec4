//! The forecast of a run: how much it would write, and how long that would take.

use crate::configuration::Config;
use crate::errors::Error;
use crate::files::Place;
use crate::formats::{Format, RunTable};
use crate::runs::Pace;
use crate::supervision::Forecast;
use crate::supervision::forecast::{TRIAL, in_parquet, in_text};
use std::path::Path;
use std::time::Instant;

/// Returns the forecast of a run without trying it.
///
/// # Errors
/// If there is no such run, or the output has no format.
pub fn forecast(config: &Config, out: &Path) -> Result<Forecast, Error> {
    let run = config.run()?;
    let table = RunTable::new(&run, &config.output.columns)?;
    Format::of(out)?.require_columns(&table)?;
    let numbers = run.pace.rows().saturating_mul(table.width() as u64);
    of(run.pace, numbers, in_text(numbers), out)
}

/// Returns the forecast of a run after trying it for a fifth of a second, or a little longer if steps are slow. Nothing
/// is written.
///
/// # Errors
/// If there is no such run, the output has no format, or one of the first steps fails.
pub fn dry_run(config: &Config, out: &Path) -> Result<Forecast, Error> {
    let (format, run) = (Format::of(out)?, config.run()?);
    let table = RunTable::new(&run, &config.output.columns)?;
    format.require_columns(&table)?;
    let width = table.width() as u64;
    let (requested, mut row) = (config.top_columns()?, Vec::new());
    let (begun, mut encoded, mut tried, mut rows) = (Instant::now(), Vec::new(), 1, 0_u64);
    let outcome = run.follow(None, |moment| {
        if run.pace.keeps(moment.step) {
            row.clear();
            row.extend_from_slice(moment.row);
            requested.iter().for_each(|columns| columns.complete(&mut row));
            format.append(&row, &mut encoded);
            rows += 1;
        }
        tried = moment.step.max(1);
        if begun.elapsed() > TRIAL { Err(Error::Interrupted { resume: None }) } else { Ok(()) }
    });
    let seconds = begun.elapsed().as_secs_f64() / tried as f64 * run.pace.schedule.steps as f64;
    match outcome {
        Ok(()) | Err(Error::Interrupted { .. }) => {}
        Err(failure) => return Err(failure),
    }
    let all = run.pace.rows();
    let text = (all as f64 * encoded.len() as f64 / rows as f64) as u64;
    let forecast = of(run.pace, all.saturating_mul(width), text, out)?;
    Ok(Forecast { seconds: Some(seconds), ..forecast })
}

/// Returns the forecast for so many numbers, or as many bytes of them in text. The formats that are made of the numbers
/// at the end need room for both.
fn of(pace: Pace, numbers: u64, text: u64, out: &Path) -> Result<Forecast, Error> {
    let (format, is_device) = (Format::of(out)?, Place::of(out)?.is_device);
    let (steps, rows) = (pace.schedule.steps, pace.rows());
    let binary = numbers.saturating_mul(8);
    let (bytes, kept) = match format {
        Format::Csv => (text, 0),
        Format::Npz => (binary, binary),
        Format::Parquet => (in_parquet(numbers), binary),
    };
    Ok(Forecast {
        out: out.into(),
        work: format!("{steps} steps, {rows} rows"),
        remedy: "raise [output] every, lower the end",
        steps: Some(steps),
        rows,
        bytes,
        room: if is_device { 0 } else { bytes.saturating_add(kept) },
        is_device,
        ..Forecast::default()
    })
}
