//! The record of a run: its largest deviations, and curves thin enough to draw.

use crate::runs::{Experiment, TopInAxes};
use heavytop::Invariant;

/// The four conserved quantities of the experiment.
pub(super) const QUANTITIES: [Invariant; 4] = [
    Invariant::Energy,
    Invariant::VerticalSquared,
    Invariant::VerticalMomentum,
    Invariant::Kovalevskaya,
];

/// The largest number of pairs of points in a curve, which is more than a page resolves.
const MOST_PAIRS: u64 = 10_000;

/// The curves and the largest deviations of one run.
#[derive(Clone, Debug)]
pub(super) struct Record {
    /// The recorded run.
    pub experiment: Experiment<TopInAxes>,
    /// The largest deviation max |quantity − initial value| of each quantity, NaN if the quantity was NaN at any
    /// step.
    pub deviations: [f64; 4],
    /// The points (t, quantity) of each curve; of a long run, the extremes of equal intervals of time.
    pub curves: [Vec<(f64, f64)>; 4],
    initial: [f64; 4],
    stretch: u64,
}

impl Record {
    /// Creates the empty record of a run.
    pub fn new(experiment: &Experiment<TopInAxes>) -> Self {
        Self {
            experiment: experiment.clone(),
            deviations: [0.0; 4],
            curves: Default::default(),
            initial: [0.0; 4],
            stretch: experiment.pace.schedule.steps.div_ceil(MOST_PAIRS),
        }
    }

    /// Adds a sample to the record.
    pub fn add(&mut self, step: u64, time: f64, values: [f64; 4]) {
        if step == 0 {
            self.initial = values;
        }
        for (i, value) in values.into_iter().enumerate() {
            let deviation = (value - self.initial[i]).abs();
            // `f64::max` would drop a NaN; a NaN in `deviations` stays.
            if deviation > self.deviations[i] || deviation.is_nan() {
                self.deviations[i] = deviation;
            }
            let curve = &mut self.curves[i];
            if step.is_multiple_of(self.stretch) {
                curve.push((time, value));
                if self.stretch > 1 {
                    curve.push((time, value));
                }
            } else if let [.., low, high] = curve.as_mut_slice() {
                low.1 = low.1.min(value);
                high.1 = high.1.max(value);
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::configuration::{Config, IntegratorConfig};

    fn record(end: f64) -> Record {
        let (step, end) = (Some(1.0), Some(end));
        let integrator = IntegratorConfig { step, end, ..IntegratorConfig::default() };
        let config = Config { integrator, ..Config::default() };
        Record::new(&config.experiment().unwrap())
    }

    #[test]
    fn short_runs_are_recorded_as_they_are() {
        let mut record = record(3.0);
        for (step, value) in [1.0, 4.0, -1.0, 2.0].into_iter().enumerate() {
            record.add(step as u64, step as f64, [value; 4]);
        }
        assert_eq!(record.curves[0], [(0.0, 1.0), (1.0, 4.0), (2.0, -1.0), (3.0, 2.0)]);
        assert_eq!(record.deviations, [3.0; 4]);
    }

    #[test]
    fn long_runs_keep_their_extremes() {
        let mut record = record(30_000.0);
        for (step, value) in [1.0, 4.0, -1.0, 2.0].into_iter().enumerate() {
            record.add(step as u64, step as f64, [value; 4]);
        }
        assert_eq!(record.curves[3], [(0.0, -1.0), (0.0, 4.0), (3.0, 2.0), (3.0, 2.0)]);
    }

    #[test]
    fn a_nan_is_not_swallowed() {
        let mut record = record(3.0);
        for (step, value) in [1.0, f64::NAN, 1.0].into_iter().enumerate() {
            record.add(step as u64, step as f64, [value; 4]);
        }
        assert!(record.deviations[0].is_nan());
    }
}
