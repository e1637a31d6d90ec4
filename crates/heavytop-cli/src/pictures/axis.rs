//! Axes of pictures: ranges, ticks and tick labels.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// A range of values with ticks at round numbers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    from: f64,
    to: f64,
    ticks: Vec<f64>,
    decimals: usize,
}

impl Axis {
    /// Creates the axis from `low` to `high` with at least `count` intervals.
    pub fn new(low: f64, high: f64, count: u32) -> Self {
        let spacing = round_spacing((high - low) / f64::from(count));
        let mut ticks = Vec::new();
        let mut index = (low / spacing).ceil();
        while index * spacing <= high && ticks.len() < 100 {
            // Adding 0 turns −0 into 0.
            ticks.push(index * spacing + 0.0);
            index += 1.0;
        }
        let decimals = (-(spacing * 1.001).log10().floor()).clamp(0.0, 15.0) as usize;
        Self { from: low, to: high, ticks, decimals }
    }

    /// Returns the place of a value: 0 at the lower end, 1 at the upper end.
    pub fn along(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }

    /// Returns the ticks and their labels.
    pub fn labels(&self) -> impl Iterator<Item = (f64, String)> {
        self.ticks.iter().map(|tick| (*tick, self.format_ext(tick)))
    }

    /// Returns the number of characters of the longest label.
    pub fn label_length(&self) -> u32 {
        let lengths = self.labels().map(|(_, label)| label.chars().count());
        lengths.max().map_or(0, |length| length as u32)
    }

    /// Creates the axis around all finite numbers, with room above and below.
    pub fn around(values: impl Iterator<Item = f64>, count: u32) -> Self {
        let finite = values.filter(|value| value.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        if low > high {
            return Self::new(0.0, 1.0, count);
        }
        // Values that differ by round-off alone are drawn as a line.
        let room = (0.05 * (high - low)).max(1e-9 * high.abs()).max(1e-12);
        Self::new(low - room, high + room, count)
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (start, end): (i32, i32)) -> i32 {
        start + (self.along(*value) * f64::from(end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { Vec::new() } else { self.ticks.clone() }
    }

    fn range(&self) -> Range<f64> {
        self.from..self.to
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, tick: &f64) -> String {
        let plain = format!("{tick:.*}", self.decimals);
        let short = if plain.len() > 14 { format!("{tick:.3e}") } else { plain };
        short.replace('-', "−")
    }
}

/// Returns the largest of 1, 2, 5 times a power of ten that does not exceed `spacing`.
fn round_spacing(spacing: f64) -> f64 {
    let power = 10_f64.powf(spacing.log10().floor());
    // The factor compensates for the rounding of the logarithm.
    let fits = |digit: &&f64| **digit * power <= spacing * 1.001;
    power * [10.0, 5.0, 2.0].iter().find(fits).unwrap_or(&1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::new(0.0, 100.0, 4);
        assert_eq!(axis.ticks, [0.0, 20.0, 40.0, 60.0, 80.0, 100.0]);
        assert_eq!(axis.format_ext(&20.0), "20");
        let axis = Axis::new(-0.013, 0.011, 4);
        let labels: Vec<String> = axis.ticks.iter().map(|t| axis.format_ext(t)).collect();
        assert_eq!(labels, ["−0.010", "−0.005", "0.000", "0.005", "0.010"]);
    }

    #[test]
    fn zero_has_no_sign() {
        let axis = Axis::new(-0.1, 1.0, 4);
        assert_eq!(axis.labels().next().map(|(_, label)| label), Some("0.0".into()));
    }

    #[test]
    fn a_constant_and_a_nan_have_an_axis() {
        let axis = Axis::around([193.0, f64::NAN, 193.0].into_iter(), 4);
        assert!(axis.from < 193.0 && axis.to > 193.0 && axis.ticks.len() > 1);
        let axis = Axis::around([f64::NAN].into_iter(), 4);
        assert_eq!((axis.from, axis.to), (0.0, 1.0));
    }

    #[test]
    fn huge_ranges_end() {
        let axis = Axis::around([-1e300, 1e300].into_iter(), 4);
        assert!(axis.ticks.len() < 12);
    }
}
