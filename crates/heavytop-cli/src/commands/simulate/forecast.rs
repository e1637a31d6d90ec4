//! The forecast of a run: how much it would write, and how long that would take.

use crate::Error;
use crate::configuration::Config;
use crate::files::Place;
use crate::formats::{Format, RunTable};
use crate::runs::Experiment;
use serde::Serialize;
use std::fmt;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The time for which a run is tried.
const TRIAL: Duration = Duration::from_millis(200);

/// The bytes of a number in text: digits, sign, point, perhaps an exponent, and a comma.
const BYTES_OF_TEXT: u64 = 20;

/// The amount that a run would write, and the time that it would take.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Forecast {
    /// The path of the output.
    pub out: PathBuf,
    /// The number of steps.
    pub steps: u64,
    /// The number of rows.
    pub rows: u64,
    /// The size of the output, bytes.
    pub bytes: u64,
    /// The room that the run needs on the disk until it is complete, bytes.
    pub room: u64,
    /// The time that the run would take here, s, estimated from its first steps; `None` if it was not tried.
    pub seconds: Option<f64>,
    /// Whether the output is a device, such as `/dev/stdout`, which needs no room.
    pub is_device: bool,
}

impl Forecast {
    /// Returns the forecast without trying the run.
    ///
    /// # Errors
    /// If there is no such run, or the output has no format.
    pub fn of(config: &Config, out: &Path) -> Result<Self, Error> {
        let experiment = config.experiment()?;
        let (format, place) = (Format::of(out)?, Place::of(out)?);
        let width = RunTable::new(&experiment).width() as u64;
        let row = if format == Format::Csv { BYTES_OF_TEXT * width } else { 8 * width };
        let mut forecast = Self {
            out: out.into(),
            steps: experiment.schedule.steps,
            rows: experiment.rows(),
            bytes: 0,
            room: 0,
            seconds: None,
            is_device: place.is_device,
        };
        forecast.set_bytes(row as f64, format);
        Ok(forecast)
    }

    /// Returns the forecast after trying the run for a fifth of a second, or a little longer if steps are slow. Nothing is
    /// written.
    ///
    /// # Errors
    /// If there is no such run, the output has no format, or one of the first steps fails.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::commands::simulate::Forecast;
    /// use heavytop_cli::configuration::Config;
    /// let forecast = Forecast::tried(&Config::default(), "top.npz".as_ref())?;
    /// assert_eq!((forecast.rows, forecast.bytes), (5001, 5001 * 11 * 8));
    /// assert!(forecast.seconds.is_some_and(|seconds| seconds < 60.0));
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn tried(config: &Config, out: &Path) -> Result<Self, Error> {
        let mut forecast = Self::of(config, out)?;
        let (experiment, format) = (config.experiment()?, Format::of(out)?);
        let trial = Trial::run(&experiment, format)?;
        forecast.set_bytes(trial.bytes as f64 / trial.rows as f64, format);
        forecast.seconds = Some(trial.seconds / trial.steps as f64 * forecast.steps as f64);
        Ok(forecast)
    }

    /// Sets the sizes from that of a row. The formats that are made of the rows at the end need twice the room.
    fn set_bytes(&mut self, row: f64, format: Format) {
        self.bytes = (self.rows as f64 * row) as u64;
        let copies = if format == Format::Csv { 1 } else { 2 };
        self.room = if self.is_device { 0 } else { self.bytes.saturating_mul(copies) };
    }
}

/// The beginning of a run.
struct Trial {
    steps: u64,
    rows: u64,
    bytes: u64,
    seconds: f64,
}

impl Trial {
    fn run(experiment: &Experiment, format: Format) -> Result<Self, Error> {
        let table = RunTable::new(experiment);
        let (mut row, mut encoded) = (Vec::new(), Vec::new());
        let mut trial = Self { steps: 1, rows: 0, bytes: 0, seconds: 0.0 };
        let begun = Instant::now();
        let outcome = experiment.follow(None, |moment| {
            table.fill(&mut row, moment);
            let written = format.encode(&row, &mut encoded);
            written.map_err(|source| Error::Write { path: PathBuf::new(), source })?;
            trial.rows += 1;
            trial.bytes += encoded.len() as u64;
            trial.steps = moment.step.max(1);
            match begun.elapsed() > TRIAL {
                true => Err(Error::Interrupted { resume: None }),
                false => Ok(()),
            }
        });
        trial.seconds = begun.elapsed().as_secs_f64();
        match outcome {
            Ok(()) | Err(Error::Interrupted { .. }) => Ok(trial),
            Err(failure) => Err(failure),
        }
    }
}

impl fmt::Display for Forecast {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { out, steps, rows, bytes, room, seconds, .. } = self;
        write!(to, "{steps} steps, {rows} rows, about {} in {}", size(*bytes), out.display())?;
        if room > bytes {
            write!(to, " ({} of disk until it is complete)", size(*room))?;
        }
        seconds.map_or(Ok(()), |seconds| write!(to, "; about {}", time(seconds)))
    }
}

/// Formats a number of bytes in decimal units.
pub(crate) fn size(bytes: u64) -> String {
    let units = [(1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB")];
    match units.iter().find(|(unit, _)| bytes as f64 >= *unit) {
        Some((unit, name)) => format!("{:.1} {name}", bytes as f64 / unit),
        None => format!("{bytes} bytes"),
    }
}

/// Formats a time in the largest unit of which there is one.
fn time(seconds: f64) -> String {
    let units = [(31_557_600.0, "years"), (86_400.0, "days"), (3600.0, "hours"), (60.0, "minutes")];
    match units.iter().find(|(unit, _)| seconds >= *unit) {
        Some((unit, name)) => format!("{:.1} {name}", seconds / unit),
        None => format!("{seconds:.2} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_times_have_their_units() {
        assert_eq!([999, 1000, 44_000_000_000_000].map(size), ["999 bytes", "1.0 kB", "44.0 TB"]);
        assert_eq!([0.5, 90.0, 1e9].map(time), ["0.50 s", "1.5 minutes", "31.7 years"]);
    }
}
