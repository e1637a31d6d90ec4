//! The colours of a heat map, whose scale is anchored at the value that has a meaning: [`MapColours`].

use super::colours::{REGULAR, bar_scale, is_megno};
use crate::configuration::Column;
use crate::pictures::Scale;
use crate::pictures::colour_scale::{colour, signed_colour};
use crate::pictures::numerals::significant;

/// The fraction of the values, at either end, that may lie outside the range of colours.
const OUTLIERS: f64 = 0.005;

/// The part of the range by which a value of that fraction may widen it.
const WIDER: f64 = 0.1;

/// The MEGNO up to which the colours reach at least. In a finite time that of regular motion is not quite 2; with a
/// narrower scale this would look like chaos.
const LEAST_CHAOS: f64 = 3.0;

/// The number of digits of the ends of the scale in words.
const DIGITS: usize = 3;

/// The colours of the values, or of the decimal logarithms, of a column.
///
/// A column with values of both signs has colours from blue over white, at 0, to red; both signs have them on one scale,
/// so that equal sizes are equally dark. MEGNO has them about 2, the value of regular motion, on a logarithmic scale.
/// Other columns have colours from dark to light.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MapColours {
    range: [f64; 2],
    /// The value that is white, and the distance from it to the darkest colour.
    middle: Option<[f64; 2]>,
    /// The number of values below and above the range, and of all.
    beyond: [usize; 2],
    all: usize,
}

impl MapColours {
    /// Returns the colours of the scaled values of a column; `None` where there is no value.
    ///
    /// The range holds all values but outliers: of the half percent at either end those that would widen it by more than a
    /// tenth.
    pub fn of(column: &Column, values: &[Option<f64>], scaled: &[Option<f64>]) -> Option<Self> {
        let mut sorted: Vec<f64> = scaled.iter().copied().flatten().collect();
        sorted.sort_by(f64::total_cmp);
        let inner = without_outliers(&sorted)?;
        let regular = (is_megno(column) && column.is_logarithmic).then(|| REGULAR.log10());
        let (range, middle) = match regular {
            Some(regular) => {
                let most = inner[1].max(LEAST_CHAOS.log10());
                let least = inner[0].clamp(2.0 * regular - most, regular);
                ([least, most], Some([regular, most - regular]))
            }
            None => {
                let [least, most] = distinct(inner, column);
                let has_signs = !column.is_logarithmic && least < 0.0 && most > 0.0;
                let middle = has_signs.then(|| [0.0, most.max(-least)]);
                ([least, most], middle)
            }
        };
        let ends = range.map(|end| if column.is_logarithmic { 10_f64.powf(end) } else { end });
        // What was raised to the least logarithm lies below the scale. The margin is that of a power.
        let margin = if column.is_logarithmic { 1e-9 * ends[0].abs() } else { 0.0 };
        let numbers = || values.iter().flatten().filter(|value| value.is_finite());
        let below = numbers().filter(|value| **value < ends[0] - margin).count();
        let above = numbers().filter(|value| **value > ends[1] + margin).count();
        Some(Self { range, middle, beyond: [below, above], all: sorted.len() })
    }

    /// Returns the colour of a scaled value.
    pub fn at(&self, value: f64) -> [u8; 3] {
        let [least, most] = self.range;
        match self.middle {
            Some([middle, half]) => signed_colour(value / half - middle / half),
            None => colour((value / 2.0 - least / 2.0) / (most / 2.0 - least / 2.0)),
        }
    }

    /// Returns the colour of a place of the bar, from 0 to 1.
    pub fn along(&self, place: f64) -> [u8; 3] {
        let [least, most] = self.range;
        self.at(least * (1.0 - place) + most * place)
    }

    /// Returns the scale of the bar of colours.
    pub fn scale(&self, column: &Column) -> Scale {
        Scale { beyond: self.beyond.map(|count| count > 0), ..bar_scale(column, self.range) }
    }

    /// Returns how many values lie outside of the scale, as the parts of a caption.
    pub fn outside(&self, column: &Column) -> Vec<String> {
        let end = |end: f64| if column.is_logarithmic { 10_f64.powf(end) } else { end };
        let words = |(mark, sign, at, count): (&str, &str, f64, usize)| {
            let (all, bound) = (self.all, significant(end(at), DIGITS));
            (count > 0).then(|| format!("{mark} {sign} {bound}: {count} of {all}"))
        };
        let ([least, most], [below, above]) = (self.range, self.beyond);
        let ends = [("▲", "&gt;", most, above), ("▼", "&lt;", least, below)];
        ends.into_iter().filter_map(words).collect()
    }
}

/// Returns the ends of the sorted values but outliers, which are farther from the others than a tenth of their range.
fn without_outliers(sorted: &[f64]) -> Option<[f64; 2]> {
    let outliers = (sorted.len() as f64 * OUTLIERS) as usize;
    let (least, most) = (*sorted.get(outliers)?, *sorted.iter().rev().nth(outliers)?);
    let room = WIDER * (most / 2.0 - least / 2.0);
    let is_near =
        |value: &&f64| **value / 2.0 - most / 2.0 <= room && least / 2.0 - **value / 2.0 <= room;
    Some([*sorted.iter().find(is_near)?, *sorted.iter().rev().find(is_near)?])
}

/// Returns the range, or a wider one where it is narrower than round-off, which thus looks constant.
fn distinct([least, most]: [f64; 2], column: &Column) -> [f64; 2] {
    let size = if column.is_logarithmic { 1.0 } else { least.abs().max(most.abs()) };
    let room = 1e-9 * size;
    match most - least > room {
        true => [least, most],
        false if size > 0.0 => [least - room, least + room],
        false => [-1.0, 1.0],
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::colours::scaled;
    use super::*;
    use crate::configuration::Observable;

    const WHITE: [u8; 3] = [247; 3];

    fn colours(column: &Column, values: &[f64]) -> (Column, MapColours) {
        let values: Vec<Option<f64>> = values.iter().copied().map(Some).collect();
        let (column, scaled) = scaled(column, &values);
        let colours = MapColours::of(&column, &values, &scaled).unwrap();
        (column, colours)
    }

    fn linear() -> Column {
        Column::linear("Pi1", "Π₁ at the end (kg m²/s)")
    }

    #[test]
    fn zero_is_white_where_there_are_both_signs_at_every_scale() {
        for size in [1e-30, 1.0, 1e30] {
            let (column, map) = colours(&linear(), &[-0.5 * size, 0.0, 2.0 * size]);
            assert_eq!(map.at(0.0), WHITE);
            assert_eq!((map.along(0.2), map.along(1.0)), (WHITE, signed_colour(1.0)));
            // Equal sizes are equally dark: the lower end is a quarter of the upper one.
            assert_eq!(map.along(0.0), signed_colour(-0.25));
            assert_eq!(map.outside(&column), [""; 0]);
            // Control: with one sign 0 is no anchor, and no colour is white.
            let (_, map) = colours(&linear(), &[0.5 * size, 2.0 * size]);
            assert!((0..=100).all(|n| map.along(f64::from(n) / 100.0) != WHITE));
        }
    }

    #[test]
    fn regular_motion_is_white_and_chaos_red() {
        let megno = &Observable::Megno.columns()[0];
        for values in [[1.9, 2.0, 2.0], [1.9, 2.0, 200.0], [50.0, 70.0, 200.0], [-1.0, 0.5, 30.0]] {
            let (_, map) = colours(megno, &values);
            assert_eq!(map.at(REGULAR.log10()), WHITE, "{values:?}");
        }
        // Regular motion of a finite time hardly has a colour, and the largest value the darkest.
        let (_, map) = colours(megno, &[1.98, 2.02]);
        assert!(map.at(2.02_f64.log10()).iter().all(|channel| *channel > 240));
        let (_, map) = colours(megno, &[1.98, 200.0]);
        assert_eq!(map.at(200_f64.log10()), signed_colour(1.0));
    }

    #[test]
    fn outliers_are_counted_and_what_lies_near_is_no_outlier() {
        let mut values: Vec<f64> = (0..1000).map(|n| 1.0 + f64::from(n) / 1000.0).collect();
        let (column, map) = colours(&linear(), &values);
        assert_eq!((map.beyond, map.outside(&column).len()), ([0, 0], 0));
        (values[0], values[998], values[999]) = (-50.0, 70.0, 90.0);
        let (column, map) = colours(&linear(), &values);
        assert_eq!(map.outside(&column), ["▲ &gt; 2: 2 of 1000", "▼ &lt; 1: 1 of 1000"]);
        assert_eq!(map.scale(&column).beyond, [true, true]);
        // A logarithm of zero is below the scale.
        let drift = Column::logarithmic("drift_h", "deviation of h (J)");
        let (column, map) = colours(&drift, &[0.0, 1e-3, 1.0]);
        assert_eq!(map.outside(&column), ["▼ &lt; 10⁻¹⁶: 1 of 3"]);
    }
}
