//! Whether memory grows from run to run.

use std::collections::BTreeMap;
use std::fmt;

/// Peaks of memory (KiB) by the numbers of the runs, for each kind of run.
#[derive(Debug, Default)]
pub struct Growth {
    peaks: BTreeMap<usize, Vec<(u64, u64)>>,
}

/// A straight line through the peaks: its slope (KiB per run), the standard error of the slope, and the mean.
#[derive(Debug)]
struct Fit {
    slope: f64,
    error: f64,
    mean: f64,
    /// The number of the last run, less that of the first.
    span: f64,
}

impl Growth {
    pub fn add(&mut self, kind: usize, number: u64, peak: u64) {
        self.peaks.entry(kind).or_default().push((number, peak));
    }

    /// Fits one slope to all runs, by least squares, after the mean of each kind of run is taken away.
    fn fit(&self) -> Fit {
        let (mut centred, mut sum) = (Vec::new(), 0.0);
        for peaks in self.peaks.values() {
            let runs = peaks.len() as f64;
            let mean = |value: fn(&(u64, u64)) -> u64| {
                peaks.iter().map(|peak| value(peak) as f64).sum::<f64>() / runs
            };
            let (number, peak) = (mean(|peak| peak.0), mean(|peak| peak.1));
            sum += peak * runs;
            centred.extend(peaks.iter().map(|&(x, y)| (x as f64 - number, y as f64 - peak)));
        }
        let runs = centred.len() as f64;
        let moment = |of: fn(&(f64, f64)) -> f64| centred.iter().map(of).sum::<f64>();
        let (squares, products) = (moment(|(x, _)| x * x), moment(|(x, y)| x * y));
        let slope = products / squares;
        let rest: f64 = centred.iter().map(|(x, y)| (y - slope * x).powi(2)).sum();
        let freedom = runs - self.peaks.len() as f64 - 1.0;
        let numbers = || self.peaks.values().flatten().map(|peak| peak.0);
        let span = numbers().max().unwrap_or(0) - numbers().min().unwrap_or(0);
        let error = (rest / freedom / squares).sqrt();
        Fit { slope, error, mean: sum / runs, span: span as f64 }
    }

    /// Checks that the slope is not distinguished from zero, or that from the first to the last run it makes no more than
    /// 2 % of the memory.
    pub fn assert_flat(&self) {
        let Fit { slope, error, mean, span } = self.fit();
        assert!(slope < 4.0 * error || slope * span < 0.02 * mean, "memory grows: {self}");
    }
}

impl fmt::Display for Growth {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Fit { slope, error, mean, span } = self.fit();
        let peaks = || self.peaks.values().flatten().map(|peak| peak.1);
        let range = peaks().min().zip(peaks().max());
        let (least, most) = range.unwrap_or_default();
        write!(
            to,
            "memory from {least} to {most} KiB, {mean:.0} on the average, in {span} runs; \
             it grows by {:.2} ± {:.2} KiB in a thousand runs",
            1e3 * slope,
            1e3 * error
        )
    }
}

/// Control: growth by 0.1 % in each run is found within noise of 2 %.
#[test]
#[should_panic(expected = "memory grows")]
fn growth_is_found() {
    let mut growth = Growth::default();
    for number in 0..100 {
        growth.add(number as usize % 3, number, 10_000 + 10 * number + 613 * number % 200);
    }
    growth.assert_flat();
}
