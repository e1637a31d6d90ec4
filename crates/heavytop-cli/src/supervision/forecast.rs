//! Forecasts of commands: how much they would write, and how long that would take.

use crate::errors::Error;
use crate::files::place::shown;
use rayon::prelude::*;
use serde::Serialize;
use std::fmt;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// The time for which a command is tried.
pub(crate) const TRIAL: Duration = Duration::from_millis(200);

/// The amount that a command would write, and the time that it would take.
///
/// # Example
/// ```
/// use heavytop_cli::commands::simulate::dry_run;
/// use heavytop_cli::configuration::Config;
/// let forecast = dry_run(&Config::default(), "top.npz".as_ref())?;
/// assert_eq!((forecast.rows, forecast.bytes), (5001, 5001 * 11 * 8));
/// assert!(forecast.to_string().starts_with("5000 steps, 5001 rows, about 440.1 kB in top.npz"));
/// # Ok::<(), heavytop_cli::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Forecast {
    /// The path of the output, a file or a folder.
    pub out: PathBuf,
    /// What is to be done, in words.
    #[serde(skip)]
    pub work: String,
    /// How to make the output smaller, in words.
    #[serde(skip)]
    pub remedy: &'static str,
    /// The number of steps of all tops together; `None` if it depends on the motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steps: Option<u64>,
    /// The number of rows of the table; the largest possible one if it depends on the motion.
    pub rows: u64,
    /// The size of the output, bytes.
    pub bytes: u64,
    /// The room that the command needs on the disk until its output is complete, bytes.
    pub room: u64,
    /// The time that the command would take here, s, estimated from a trial; `None` if there was none.
    pub seconds: Option<f64>,
    /// Whether the output is a device, such as `/dev/stdout`, which needs no room.
    pub is_device: bool,
}

impl fmt::Display for Forecast {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { out, work, bytes, room, seconds, .. } = self;
        write!(to, "{work}, about {} in {}", size(*bytes), shown(out))?;
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

/// Formats a time in the largest unit that it reaches.
pub(crate) fn time(seconds: f64) -> String {
    let units = [(31_557_600.0, "years"), (86_400.0, "days"), (3600.0, "hours"), (60.0, "minutes")];
    match units.iter().find(|(unit, _)| seconds >= *unit) {
        Some((unit, name)) => format!("{:.1} {name}", seconds / unit),
        None => format!("{seconds:.2} s"),
    }
}

/// Returns the bytes of numbers in text: digits, sign, point, perhaps an exponent, and a comma.
pub(crate) fn in_text(numbers: u64) -> u64 {
    numbers.saturating_mul(20)
}

/// Returns about the bytes of numbers in a Parquet file. The last digits of a motion have no pattern.
pub(crate) fn in_parquet(numbers: u64) -> u64 {
    numbers.saturating_mul(8) / 10 * 6
}

/// Returns the time that independent parts of a command take on the current threads, s, estimated from some of them.
///
/// `seconds` gives the time of one part, by its number, on one thread.
pub(crate) fn time_of_all(
    parts: u64,
    seconds: impl Fn(u64) -> Result<f64, Error> + Sync,
) -> Result<f64, Error> {
    let threads = rayon::current_num_threads() as u64;
    let (begun, mut tried, mut sum) = (Instant::now(), 0, 0.0);
    while tried == 0 || begun.elapsed() < TRIAL {
        let group = (tried..tried + threads).into_par_iter().map(|n| seconds(spread(n, parts)));
        sum += group.try_reduce(|| 0.0, |a, b| Ok(a + b))?;
        tried += threads;
    }
    // Few parts leave threads without work.
    Ok(sum / tried as f64 * parts as f64 / threads.min(parts) as f64)
}

/// Returns the n-th of some numbers below `count` that are spread evenly however many there are, by Weyl's sequence.
fn spread(n: u64, count: u64) -> u64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    ((n as f64 * GOLDEN).fract() * count as f64) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_times_have_their_units() {
        assert_eq!([999, 1000, 44_000_000_000_000].map(size), ["999 bytes", "1.0 kB", "44.0 TB"]);
        assert_eq!([0.5, 90.0, 1e9].map(time), ["0.50 s", "1.5 minutes", "31.7 years"]);
    }

    #[test]
    fn numbers_are_spread_over_the_whole_range() {
        for count in [1, 10, 1000] {
            let mut numbers: Vec<u64> = (0..20).map(|n| spread(n, count)).collect();
            assert!(numbers.iter().all(|n| *n < count));
            numbers.sort_unstable();
            // Twenty numbers leave no gap of an eighth.
            let gap = numbers.windows(2).map(|pair| pair[1] - pair[0]).max();
            assert!(gap.is_some_and(|gap| gap <= 1 + count / 8), "{count}: {numbers:?}");
        }
    }
}
