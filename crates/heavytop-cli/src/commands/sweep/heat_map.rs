//! The heat map of a grid with two axes, as SVG.

use super::sweep_plan::Plan;
use crate::Error;
use crate::configuration::{Column, Spread, SweepAxis};
use crate::pictures::Axis;
use crate::pictures::colour_scale::colour;
use crate::pictures::render::FONT;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use resvg::tiny_skia::{ColorU8, Pixmap};
use std::fmt::Write;

/// The width of the picture, in units of 0.01 mm.
const WIDTH: f64 = 12_000.0;
const HEIGHT: f64 = 10_000.0;
const LEFT: f64 = 1500.0;
const TOP: f64 = 500.0;
const RIGHT: f64 = WIDTH - 2700.0;
const BOTTOM: f64 = HEIGHT - 1100.0;
/// The left and the right edge of the bar of colours.
const BAR: (f64, f64) = (RIGHT + 350.0, RIGHT + 650.0);

/// The size of the text, 8 pt.
const TEXT: f64 = 282.0;
const RULE: f64 = 14.0;

/// The colours of the values, from dark to light.
const COLOURS: [[f64; 3]; 6] = [
    [20.0, 20.0, 60.0],
    [60.0, 40.0, 130.0],
    [150.0, 50.0, 130.0],
    [225.0, 90.0, 80.0],
    [250.0, 170.0, 70.0],
    [250.0, 245.0, 190.0],
];

/// The colour of tops without a value.
const NONE: [f64; 3] = [190.0; 3];

/// The smallest number whose logarithm is distinguished.
const SMALLEST: f64 = 1e-16;

/// The number of ticks below which they do not show a scale.
const FEW: usize = 3;

/// The fraction of the values, at either end, that may lie outside the range of colours.
const OUTLIERS: f64 = 0.005;

/// The largest number of tops of a map; more would have more pixels than a screen, and take gigabytes.
const MOST_TOPS: u64 = 1 << 24;

/// Returns the number of columns and rows of a sweep's maps; `None` unless the sweep is a grid with two axes.
pub(super) fn size(plan: &Plan) -> Option<[u32; 2]> {
    let [first, second] = plan.axes.as_slice() else { return None };
    match (first.spread, second.spread) {
        (Spread::Grid { count: columns, .. }, Spread::Grid { count: rows, .. })
            if plan.tops <= MOST_TOPS =>
        {
            Some([columns, rows])
        }
        _ => None,
    }
}

/// Draws the values over the plane of the two axes; the sweep has maps of this size.
///
/// # Errors
/// If the map cannot be drawn.
pub(super) fn heat_map(
    plan: &Plan,
    [columns, rows]: [u32; 2],
    column: &Column,
    values: &[Option<f64>],
) -> Result<String, Error> {
    let scaled =
        |value: f64| if column.is_logarithmic { value.max(SMALLEST).log10() } else { value };
    let scaled: Vec<Option<f64>> = values.iter().map(|value| value.map(scaled)).collect();
    let range = range(&scaled);
    let bar = (1..=256).map(|n| Some(range[1] + (range[0] - range[1]) * f64::from(n) / 256.0));
    let bar: Vec<Option<f64>> = bar.collect();
    // The first axis is the abscissa, and the top row has the largest value of the second.
    let (width, height) = (columns as usize, rows as usize);
    let from_top = (0..height).rev().flat_map(|y| (0..width).map(move |x| x * height + y));
    let cells: Vec<Option<f64>> =
        from_top.map(|index| scaled.get(index).copied().flatten()).collect();

    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" \
         viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"{FONT}\" font-size=\"{TEXT}\">\
         <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>",
        WIDTH / 100.0,
        HEIGHT / 100.0
    );
    image(&mut svg, (LEFT, RIGHT), &pixels(columns, rows, &cells, range)?);
    image(&mut svg, BAR, &pixels(1, 256, &bar, range)?);
    frame(&mut svg, &plan.axes);
    legend(&mut svg, column, range);
    Ok(svg + "</svg>")
}

/// Returns the range of the colours: all values but outliers.
fn range(values: &[Option<f64>]) -> [f64; 2] {
    let mut sorted: Vec<f64> = values.iter().copied().flatten().collect();
    sorted.sort_by(f64::total_cmp);
    let outliers = (sorted.len() as f64 * OUTLIERS) as usize;
    let least = sorted.get(outliers).copied().unwrap_or(0.0);
    let most = sorted.iter().rev().nth(outliers).copied().unwrap_or(0.0);
    // The range is not narrowed to round-off, which thus looks constant.
    let room = (1e-9 * least.abs()).max(1e-12);
    if most - least > room { [least, most] } else { [least - room, least + room] }
}

/// Encodes the values as a PNG with one pixel each.
fn pixels(
    width: u32,
    height: u32,
    values: &[Option<f64>],
    [least, most]: [f64; 2],
) -> Result<Vec<u8>, Error> {
    let mut picture = Pixmap::new(width, height)
        .ok_or_else(|| Error::Figure(format!("{width} × {height} tops are too many")))?;
    for (pixel, value) in picture.pixels_mut().iter_mut().zip(values) {
        let [red, green, blue] = value.map_or(NONE, |value| {
            colour(&COLOURS, (value - least) / (most - least)).map(f64::round)
        });
        *pixel = ColorU8::from_rgba(red as u8, green as u8, blue as u8, 255).premultiply();
    }
    picture.encode_png().map_err(|error| Error::Figure(error.to_string()))
}

// Writing to a string does not fail.

fn image(svg: &mut String, (left, right): (f64, f64), png: &[u8]) {
    let (width, height) = (right - left, BOTTOM - TOP);
    let _ = write!(
        svg,
        "<image x=\"{left}\" y=\"{TOP}\" width=\"{width}\" height=\"{height}\" \
         preserveAspectRatio=\"none\" image-rendering=\"optimizeSpeed\" \
         href=\"data:image/png;base64,{}\"/>\
         <rect x=\"{left}\" y=\"{TOP}\" width=\"{width}\" height=\"{height}\" fill=\"none\" \
         stroke=\"black\" stroke-width=\"{RULE}\"/>",
        STANDARD.encode(png)
    );
}

/// The range, the ticks and the label of an axis of the map.
struct Marks {
    axis: Axis,
    label: String,
    reversed: bool,
}

impl Marks {
    fn of(axis: &SweepAxis) -> Self {
        let (from, to, count) = match axis.spread {
            Spread::Grid { from, to, count } => (from, to, count),
            Spread::Uniform { from, to } => (from, to, 2),
            Spread::Normal { mean, deviation } => (mean - deviation, mean + deviation, 2),
        };
        // Values are in the middle of their pixels.
        let half = (to - from).abs() / f64::from(2 * count.max(2) - 2);
        let (low, high) = (from.min(to) - half, from.max(to) + half);
        let room = (1e-9 * low.abs()).max(1e-12);
        let high = if high - low > room { high } else { low + room };
        Self { axis: Axis::new(low, high, 5), label: axis.parameter.label(), reversed: from > to }
    }

    /// Returns the places of the ticks, from 0 to 1, and their labels.
    fn ticks(&self) -> impl Iterator<Item = (f64, String)> {
        let turned = |along: f64| if self.reversed { 1.0 - along } else { along };
        self.axis.labels().map(move |(value, label)| (turned(self.axis.along(value)), label))
    }
}

fn frame(svg: &mut String, axes: &[SweepAxis]) {
    let marks: Vec<Marks> = axes.iter().map(Marks::of).collect();
    let [first, second] = marks.as_slice() else { return };
    let (width, height) = (RIGHT - LEFT, BOTTOM - TOP);
    let mut ticks = String::new();
    svg.push_str("<g text-anchor=\"middle\">");
    for (along, label) in first.ticks() {
        let x = LEFT + width * along;
        let _ = write!(ticks, "M{x:.0} {BOTTOM}v90");
        let _ = write!(svg, "<text x=\"{x:.0}\" y=\"{}\">{label}</text>", BOTTOM + 400.0);
    }
    let _ = write!(
        svg,
        "<text x=\"{}\" y=\"{}\">{}</text><text transform=\"translate(400 {}) rotate(-90)\">{}</text>\
         </g><g text-anchor=\"end\">",
        (LEFT + RIGHT) / 2.0,
        HEIGHT - 240.0,
        first.label,
        (TOP + BOTTOM) / 2.0,
        second.label,
    );
    for (along, label) in second.ticks() {
        let y = BOTTOM - height * along;
        let _ = write!(ticks, "M{LEFT} {y:.0}h-90");
        let _ = write!(svg, "<text x=\"{}\" y=\"{:.0}\">{label}</text>", LEFT - 150.0, y + 100.0);
    }
    let _ = write!(svg, "</g><path d=\"{ticks}\" stroke=\"black\" stroke-width=\"{RULE}\"/>");
}

fn legend(svg: &mut String, column: &Column, range: [f64; 2]) {
    let (from, right) = (BAR.1, BAR.1 + 150.0);
    let mut ticks = String::new();
    for (along, label) in marks(column, range) {
        let y = BOTTOM - (BOTTOM - TOP) * along;
        let _ = write!(ticks, "M{from} {y:.0}h90");
        let _ = write!(svg, "<text x=\"{right}\" y=\"{:.0}\">{label}</text>", y + 100.0);
    }
    let _ = write!(
        svg,
        "<path d=\"{ticks}\" stroke=\"black\" stroke-width=\"{RULE}\"/>\
         <text transform=\"translate({} {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
        BAR.1 + 1250.0,
        (TOP + BOTTOM) / 2.0,
        column.label
    );
}

/// Returns the ticks of the bar, from 0 to 1, and their labels.
///
/// On a logarithmic scale they are 1, 2 and 5 times powers of ten. Where that gives too many they are powers of ten
/// alone; where it gives too few they are other round numbers.
fn marks(column: &Column, [least, most]: [f64; 2]) -> Vec<(f64, String)> {
    if !column.is_logarithmic {
        let axis = Axis::new(least, most, 6);
        return axis.labels().map(|(value, label)| (axis.along(value), label)).collect();
    }
    let decades = least.floor() as i32..=most.ceil() as i32;
    let digits: &[f64] = if most - least > 3.0 { &[1.0] } else { &[1.0, 2.0, 5.0] };
    let every = if most - least > 8.0 { 2 } else { 1 };
    let ticks = decades.filter(|decade| decade % every == 0);
    let ticks = ticks.flat_map(|decade| digits.iter().map(move |digit| (decade, digit)));
    let along = |(decade, digit): (i32, &f64)| {
        let along = (f64::from(decade) + digit.log10() - least) / (most - least);
        let value = digit * 10_f64.powi(decade);
        let label = if (-2..4).contains(&decade) {
            format!("{value:.*}", usize::try_from(-decade).unwrap_or(0))
        } else {
            format!("{value:.0e}").replace('-', "−")
        };
        (0.0..=1.0).contains(&along).then_some((along, label))
    };
    let ticks: Vec<(f64, String)> = ticks.filter_map(along).collect();
    if ticks.len() >= FEW {
        return ticks;
    }
    let axis = Axis::new(10_f64.powf(least), 10_f64.powf(most), 4);
    let along = |value: f64| (value.log10() - least) / (most - least);
    axis.labels().map(|(value, label)| (along(value), label)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::Observable;

    #[test]
    fn a_bar_of_logarithms_has_ticks_enough_and_in_order() {
        let [megno] = Observable::Megno.columns() else { return };
        let labels = |least: f64, most: f64| -> Vec<String> {
            let marks = marks(megno, [least.log10(), most.log10()]);
            assert!(marks.is_sorted_by(|a, b| a.0 < b.0), "{marks:?}");
            assert!(marks.iter().all(|(along, _)| (0.0..=1.0).contains(along)), "{marks:?}");
            marks.into_iter().map(|(_, label)| label).collect()
        };
        // Between 1 and 5 there is only 2 among 1, 2 and 5 times powers of ten.
        assert_eq!(labels(1.45, 2.35), ["1.6", "1.8", "2.0", "2.2"]);
        assert_eq!(labels(0.9, 11.0), ["1", "2", "5", "10"]);
        assert_eq!(labels(1e-3, 50.0), ["1e−3", "0.01", "0.1", "1", "10"]);
    }
}
