//! The ticks and the title of an axis or of a bar of colours, by their places.

use super::axis::Axis;
use crate::pictures::lettering::widest;
use crate::pictures::numerals::exact;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// The number of ticks below which they do not show a logarithmic scale.
const FEW: usize = 3;

/// The ticks and the title of an axis; it has none by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Scale {
    /// The places of the ticks, from 0 to 1, and their labels.
    pub ticks: Vec<(f64, String)>,
    /// The quantity with its unit.
    pub title: String,
    /// The place of a line across a bar of colours.
    pub line: Option<f64>,
    /// Whether there are values below and above a bar of colours, which then ends in points.
    pub beyond: [bool; 2],
}

impl Scale {
    /// Creates the scale of an axis for a quantity, written as "symbol (unit)". A reversed axis begins at its end.
    pub fn linear(axis: &Axis, quantity: &str, reversed: bool) -> Self {
        let place = |value: f64| if reversed { 1.0 - axis.along(value) } else { axis.along(value) };
        let ticks = axis.labels().map(|(value, label)| (place(value), label.into())).collect();
        Self { ticks, title: axis.title(quantity), ..Self::default() }
    }

    /// Creates the scale of a quantity between these decimal logarithms.
    ///
    /// Its ticks are 1, 2 and 5 times powers of ten. Where that gives too many they are powers of ten alone; where it
    /// gives too few they are other round numbers.
    pub fn logarithmic([least, most]: [f64; 2], quantity: &str) -> Self {
        let decades = least.floor() as i32..=most.ceil() as i32;
        let digits: &[i32] = if most - least > 3.0 { &[1] } else { &[1, 2, 5] };
        let every = ((most - least) / 8.0).ceil().max(1.0) as i32;
        let along = |value: f64| (value.log10() - least) / (most - least);
        let ticks = decades.filter(|decade| decade % every == 0);
        let values =
            ticks.flat_map(|decade| digits.iter().map(move |digit| format!("{digit}e{decade}")));
        let values = values.filter_map(|text| text.parse::<f64>().ok());
        let ticks: Vec<(f64, String)> = values
            .map(|value| (along(value), exact(value)))
            .filter(|(along, _)| (0.0..=1.0).contains(along))
            .collect();
        if ticks.len() >= FEW {
            return Self { ticks, title: quantity.into(), ..Self::default() };
        }
        let axis = Axis::new(10_f64.powf(least), 10_f64.powf(most), 4);
        let labels = axis.labels().map(|(value, label)| (along(value), label.into()));
        let ticks = labels.filter(|(along, _)| (0.0..=1.0).contains(along)).collect();
        Self { ticks, title: axis.title(quantity), ..Self::default() }
    }

    /// Draws a line at a place, with a label instead of those of the ticks that are nearer to it than `apart`.
    pub fn with_line(mut self, place: f64, label: &str, apart: f64) -> Self {
        self.ticks.retain(|(tick, _)| (tick - place).abs() > apart);
        self.ticks.push((place, label.into()));
        self.ticks.sort_by(|one, other| one.0.total_cmp(&other.0));
        self.line = Some(place);
        self
    }

    /// Returns the width of the widest label, as a multiple of its size.
    pub fn label_width(&self) -> f64 {
        widest(self.ticks.iter().map(|(_, label)| label.as_str()))
    }
}

/// The coordinates of a chart are places; what is drawn thus never depends on the unit of a quantity.
impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, along: &f64, (from, to): (i32, i32)) -> i32 {
        from.saturating_add((f64::from(to - from) * along).round() as i32)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        match hint.weight().allow_light_points() {
            true => Vec::new(),
            false => self.ticks.iter().map(|(along, _)| *along).collect(),
        }
    }

    fn range(&self) -> Range<f64> {
        0.0..1.0
    }
}

impl ValueFormatter<f64> for Scale {
    fn format_ext(&self, along: &f64) -> String {
        let tick = self.ticks.iter().find(|(place, _)| place == along);
        tick.map_or_else(String::new, |(_, label)| label.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plotters::coord::ranged1d::{BoldPoints, LightPoints};

    #[test]
    fn a_logarithmic_scale_has_ticks_enough_and_in_order() {
        let labels = |least: f64, most: f64| -> Vec<String> {
            let ticks = Scale::logarithmic([least.log10(), most.log10()], "MEGNO").ticks;
            assert!(ticks.is_sorted_by(|a, b| a.0 < b.0), "{ticks:?}");
            assert!(ticks.iter().all(|(along, _)| (0.0..=1.0).contains(along)), "{ticks:?}");
            ticks.into_iter().map(|(_, label)| label).collect()
        };
        // Between 1 and 5 there is only 2 among 1, 2 and 5 times powers of ten.
        assert_eq!(labels(1.45, 2.35), ["1.6", "1.8", "2.0", "2.2"]);
        assert_eq!(labels(0.9, 11.0), ["1", "2", "5", "10"]);
        assert_eq!(labels(1e-3, 50.0), ["0.001", "0.01", "0.1", "1", "10"]);
        assert_eq!(labels(9e-21, 1.9e-19), ["10⁻²⁰", "2×10⁻²⁰", "5×10⁻²⁰", "10⁻¹⁹"]);
        assert!(labels(1e-20, 1e20).len() <= 9);
    }

    #[test]
    fn a_marked_value_replaces_the_ticks_beside_it() {
        let scale = Scale::logarithmic([0.0, 1.0], "MEGNO").with_line(0.31, "2 (regular)", 0.05);
        let labels: Vec<&str> = scale.ticks.iter().map(|(_, label)| label.as_str()).collect();
        assert_eq!(labels, ["1", "2 (regular)", "5", "10"]);
    }

    /// The ticks and the labels of a chart are those of the scale, and no place leads to an overflow.
    #[test]
    fn charts_have_the_ticks_of_the_scale() {
        let scale = Scale::linear(&Axis::new(-1e300, 1e300, 4), "h (J)", false);
        let labels = |places: Vec<f64>| -> Vec<String> {
            places.iter().map(|place| scale.format_ext(place)).collect()
        };
        assert_eq!(labels(scale.key_points(BoldPoints(1))), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        // Controls: there are none for fine lines, and no label beside a tick.
        assert!(scale.key_points(LightPoints::new(9, 9)).is_empty());
        assert_eq!(labels(vec![0.1]), [""]);
        assert_eq!([0.0, 0.25, 1.0].map(|along| scale.map(&along, (900, 100))), [900, 700, 100]);
        for along in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
            let _ = scale.map(&along, (900, 100));
            let _ = scale.map(&along, (100, 900));
        }
    }
}
