//! Axes of pictures: ranges, ticks and tick labels.

use crate::pictures::lettering::width;
use crate::pictures::numerals::{exact, power_of_ten};

/// The largest number of ticks.
const MOST_TICKS: usize = 100;

/// The number of significant digits from which labels are relative to an offset.
const MOST_DIGITS: i32 = 6;

/// The decimal exponents of the largest label that need no power of ten in the title.
const PLAIN: std::ops::RangeInclusive<i32> = -2..=4;

/// The least span of an axis, relative to its values; values that differ by less are drawn as a line.
const LEAST_SPAN: f64 = 1e-9;

/// A range of values with ticks at round numbers.
///
/// Where labels would be long, or small, they count a power of ten from an offset, and the title says both:
/// value = offset + label × 10^exponent.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    from: f64,
    to: f64,
    ticks: Vec<(f64, String)>,
    offset: f64,
    exponent: i32,
}

impl Axis {
    /// Creates the axis from `low` to `high` with at least `count` intervals. An empty range is widened.
    pub fn new(low: f64, high: f64, count: u32) -> Self {
        let (from, to) = widened(low, high);
        let (digit, power) = {
            let count = f64::from(count.max(1));
            round_spacing((to / count - from / count).min(f64::MAX))
        };
        let spacing = decimal(digit, power);
        let first = (from / spacing).ceil() as i64;
        let last = (to / spacing).floor() as i64;
        let last = last.min(first.saturating_add(MOST_TICKS as i64));

        let digits = decade(from.abs().max(to.abs())) - power + 1;
        // The offset is a multiple of ten spacings or less, so that ticks are whole spacings apart from it.
        let [offset, origin] = if digits > MOST_DIGITS {
            let tens = ((from / 2.0 + to / 2.0) / decimal(1, power + 1)).round() as i64;
            [tens, tens.saturating_mul(10 / digit)]
        } else {
            [0, 0]
        };
        let largest = (first - origin).abs().max((last - origin).abs());
        let top = if largest > 0 { decade((largest * digit) as f64) + power } else { power };
        let exponent = if PLAIN.contains(&top) { 0 } else { top };
        let decimals = usize::try_from(exponent - power).unwrap_or(0);
        let tick = |index: i64| {
            let label =
                format!("{:.decimals$}", decimal((index - origin) * digit, power - exponent));
            (decimal(index * digit, power), label.replace('-', "−"))
        };
        let ticks = (first..=last).map(tick).collect();
        Self { from, to, ticks, offset: decimal(offset, power + 1), exponent }
    }

    /// Creates the axis with as many intervals as its labels have room for side by side, at most `count`. The axis
    /// has this length, as a multiple of the size of the labels.
    pub fn along_line(low: f64, high: f64, count: u32, length: f64) -> Self {
        let axes = (1..=count).rev().map(|count| Self::new(low, high, count));
        let mut axis = Self::new(low, high, count);
        for narrower in axes {
            axis = narrower;
            if axis.labels_are_apart(length) {
                return axis;
            }
        }
        // Not even few labels have room: the first one alone does.
        axis.ticks.truncate(1);
        axis
    }

    fn labels_are_apart(&self, length: f64) -> bool {
        const GAP: f64 = 0.8;
        self.ticks.windows(2).all(|pair| {
            let [(one, first), (other, second)] = pair else { return true };
            let distance = length * (self.along(*other) - self.along(*one));
            (width(first) + width(second)) / 2.0 + GAP <= distance
        })
    }

    /// Returns the place of a value: 0 at the lower end, 1 at the upper end.
    pub fn along(&self, value: f64) -> f64 {
        (value / 2.0 - self.from / 2.0) / (self.to / 2.0 - self.from / 2.0)
    }

    /// Returns the ticks and their labels.
    pub fn labels(&self) -> impl Iterator<Item = (f64, &str)> {
        self.ticks.iter().map(|(tick, label)| (*tick, label.as_str()))
    }

    /// Returns the title for a quantity, written as "symbol (unit)" or "symbol", with the offset and the power of ten
    /// of the labels.
    pub fn title(&self, quantity: &str) -> String {
        let (symbol, unit) = match quantity.split_once(" (") {
            Some((symbol, unit)) => (symbol, unit.strip_suffix(')').unwrap_or(unit)),
            None => (quantity, ""),
        };
        let sign = if self.offset < 0.0 { "+" } else { "−" };
        let shift = match self.offset {
            0.0 => String::new(),
            offset => format!(" {sign} {}", exact(offset.abs())),
        };
        let unit = match (self.exponent, unit) {
            (0, "") => String::new(),
            (0, unit) => format!(" ({unit})"),
            (exponent, "") => format!(" ({})", power_of_ten(exponent)),
            (exponent, unit) => format!(" ({} {unit})", power_of_ten(exponent)),
        };
        format!("{symbol}{shift}{unit}")
    }

    /// Creates the axis around all finite numbers, with room above and below.
    pub fn around(values: impl Iterator<Item = f64>, count: u32) -> Self {
        let (low, high) = surroundings(values);
        Self::new(low, high, count)
    }

    /// Creates the axis around all finite numbers as [`along_line`](Self::along_line) does.
    pub fn around_along_line(values: impl Iterator<Item = f64>, count: u32, length: f64) -> Self {
        let (low, high) = surroundings(values);
        Self::along_line(low, high, count, length)
    }
}

/// Returns a range around all finite numbers, with room below and above; from 0 to 1 if there are none.
fn surroundings(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let finite = values.filter(|value| value.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high {
        return (0.0, 1.0);
    }
    let (low, high) = widened(low, high);
    let room = 0.05 * high - 0.05 * low;
    (low - room, high + room)
}

/// Returns the range, or a wider one where it is narrower than round-off.
fn widened(low: f64, high: f64) -> (f64, f64) {
    let (low, high) = (low.max(-f64::MAX), high.min(f64::MAX));
    let size = low.abs().max(high.abs());
    if high - low > LEAST_SPAN * size {
        (low, high)
    } else if size > 0.0 {
        let room = LEAST_SPAN * size;
        ((low - room).max(-f64::MAX), (high + room).min(f64::MAX))
    } else {
        (-1.0, 1.0)
    }
}

/// Returns digits × 10^power, correctly rounded.
fn decimal(digits: i64, power: i32) -> f64 {
    format!("{digits}e{power}").parse().unwrap_or(0.0)
}

/// Returns the exponent of the largest power of ten that does not exceed the number, but for rounding.
fn decade(x: f64) -> i32 {
    (x.log10() + 4e-7).floor() as i32
}

/// Returns the digit and the power of the largest of 1, 2, 5 times a power of ten that does not exceed `spacing`.
fn round_spacing(spacing: f64) -> (i64, i32) {
    let power = spacing.log10().floor() as i32;
    // The factor compensates for the rounding of the logarithm.
    let fits = |digit: &&i64| {
        let rounded = decimal(**digit, power);
        rounded.is_finite() && rounded <= spacing * 1.001
    };
    match [10, 5, 2].iter().find(fits) {
        Some(10) => (1, power + 1),
        Some(digit) => (*digit, power),
        None => (1, power),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<&str> {
        axis.labels().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::new(0.0, 100.0, 4);
        assert!(axis.labels().map(|(tick, _)| tick).eq([0.0, 20.0, 40.0, 60.0, 80.0, 100.0]));
        assert_eq!(axis.labels().nth(1), Some((20.0, "20")));
        assert_eq!(axis.title("t (s)"), "t (s)");
        let axis = Axis::new(-0.013, 0.011, 4);
        assert_eq!(labels(&axis), ["−0.010", "−0.005", "0.000", "0.005", "0.010"]);
        let axis = Axis::new(11.7488, 11.7511, 4);
        assert_eq!(labels(&axis), ["11.7490", "11.7495", "11.7500", "11.7505", "11.7510"]);
    }

    #[test]
    fn small_and_large_values_have_a_power_of_ten_in_the_title() {
        let axis = Axis::new(-4e-4, 4e-4, 4);
        assert_eq!(labels(&axis), ["−4", "−2", "0", "2", "4"]);
        assert_eq!(axis.title("Π₃ (kg m²/s)"), "Π₃ (10⁻⁴ kg m²/s)");
        assert_eq!(axis.title("Γ₃"), "Γ₃ (10⁻⁴)");
        let axis = Axis::new(0.0, 3e20, 3);
        assert_eq!(
            (labels(&axis), axis.title("h (J)")),
            (vec!["0", "1", "2", "3"], "h (10²⁰ J)".into())
        );
    }

    #[test]
    fn values_that_are_nearly_equal_have_an_offset_in_the_title() {
        let axis = Axis::new(193.0 - 2.1e-7, 193.0 + 2.1e-7, 4);
        assert_eq!(labels(&axis), ["−2", "−1", "0", "1", "2"]);
        assert_eq!(axis.title("K ((kg m²/s)⁴)"), "K − 193 (10⁻⁷ (kg m²/s)⁴)");
        let axis = Axis::new(-11.75e-3 - 3e-11, -11.75e-3 + 3e-11, 3);
        assert_eq!(axis.title("h (J)"), "h + 0.01175 (10⁻¹¹ J)");
    }

    /// The label, the offset and the power of ten give the tick, to the digits of an `f64`.
    #[test]
    fn labels_differ_and_tell_the_value_at_every_scale() {
        for power in [-300, -20, -9, -4, -3, -1, 0, 1, 4, 9, 20, 300] {
            for (low, high) in [
                (0.0, 1.0),
                (-0.3, 0.7),
                (0.999, 1.001),
                (1.0, 1.0 + 3e-9),
                (-1.000_000_3, -1.0),
                (1.23, 1.23),
                (0.0, 0.0),
            ] {
                for count in [4, 6] {
                    let unit = decimal(1, power);
                    let axis = Axis::new(low * unit, high * unit, count);
                    let labels = labels(&axis);
                    let mut distinct = labels.clone();
                    distinct.dedup();
                    assert_eq!(distinct, labels, "{low} to {high} × 10^{power}");
                    assert!(labels.len() >= 2 && labels.len() <= 30, "{labels:?}");
                    assert!(labels.iter().all(|label| label.chars().count() <= 9), "{labels:?}");
                    for (tick, label) in axis.labels() {
                        let label: f64 = label.replace('−', "-").parse().unwrap_or(f64::NAN);
                        let told = axis.offset + label * decimal(1, axis.exponent);
                        assert!(
                            (told - tick).abs() <= 1e-14 * tick.abs().max(unit),
                            "{told} {tick}"
                        );
                    }
                }
            }
        }
        // Control: without an offset two ticks of a narrow axis have the same label of six digits.
        let axis = Axis::new(1.0, 1.0 + 3e-9, 4);
        let six: Vec<String> = axis.labels().map(|(tick, _)| format!("{tick:.5}")).collect();
        assert!(six[0] == six[1]);
    }

    #[test]
    fn labels_side_by_side_have_room() {
        let ends = |axis: &Axis| {
            axis.labels()
                .map(|(at, label)| (30.0 * axis.along(at), width(label)))
                .collect::<Vec<_>>()
        };
        for (low, high) in [(-4.0, 4.0), (0.001_234_5, 0.001_234_6), (1e6, 1.3e6), (99.97, 100.04)]
        {
            let axis = Axis::along_line(low, high, 8, 30.0);
            let places = ends(&axis);
            let apart = |pair: &[(f64, f64)]| pair[1].0 - pair[0].0 > (pair[0].1 + pair[1].1) / 2.0;
            assert!(places.len() >= 2 && places.windows(2).all(apart), "{places:?}");
        }
        // Control: as many ticks as asked for would not have room.
        let places = ends(&Axis::new(99.97, 100.04, 8));
        assert!(places.windows(2).any(|pair| pair[1].0 - pair[0].0 < pair[0].1));
    }

    #[test]
    fn zero_has_no_sign() {
        let axis = Axis::new(-0.1, 1.0, 4);
        assert_eq!(labels(&axis)[0], "0.0");
    }

    #[test]
    fn a_constant_and_a_nan_have_an_axis() {
        let axis = Axis::around([193.0, f64::NAN, 193.0].into_iter(), 4);
        assert!(axis.from < 193.0 && axis.to > 193.0 && axis.ticks.len() > 1);
        let axis = Axis::around([f64::NAN].into_iter(), 4);
        assert_eq!((axis.from, axis.to), (0.0, 1.0));
        // A quantity of a laboratory top is not taken for zero.
        let axis = Axis::around([1e-20, 3e-20].into_iter(), 4);
        assert!(axis.along(1e-20) < 0.1 && axis.along(3e-20) > 0.9);
    }

    #[test]
    fn huge_ranges_end() {
        for (end, count) in
            [1e300, 1e308, f64::MAX].into_iter().flat_map(|e| [(e, 1), (e, 2), (e, 4)])
        {
            let axis = Axis::around([-end, end].into_iter(), count);
            assert!((1..12).contains(&axis.ticks.len()), "{end:e}: {:?}", axis.ticks);
            assert!((axis.along(0.0) - 0.5).abs() < 1e-15);
        }
        let axis = Axis::new(f64::MAX, f64::MAX, 4);
        assert!((0.0..=1.0).contains(&axis.along(f64::MAX)), "{}", axis.along(f64::MAX));
    }
}
