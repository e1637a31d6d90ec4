//! Drawing of a figure as SVG whose text is still text.

use super::figures::Figure;
use crate::pictures::Axis;
use crate::pictures::lettering::{FONT, fitting, lines, widest, width};
use std::fmt::Write;

/// The width of one column of a journal, in units of 0.01 mm.
const WIDTH: f64 = 8000.0;
const HEIGHT: f64 = 5800.0;

const MILLIMETRE: f64 = 100.0;
/// The size of the text, 7 pt.
const TEXT: f64 = 247.0;
/// The size of the caption, 5.5 pt.
const SMALL: f64 = 194.0;
/// The width of curves, 0.6 pt.
const CURVE: f64 = 21.0;
/// The width of rules, 0.4 pt.
const RULE: f64 = 14.0;
const LEGEND_ROW: f64 = 350.0;
const CAPTION_ROW: f64 = 250.0;
/// The distance of titles and captions from the edge.
const EDGE: f64 = 90.0;
/// The distance of labels from their axis.
const GAP: f64 = 2.0 * MILLIMETRE;
/// The space below the abscissa, for its labels and its title.
const BELOW: f64 = 8.0 * MILLIMETRE;
/// The heights of digits above their base line, and of its middle, as multiples of their size.
const DIGIT: f64 = 0.76;
const HALF_A_DIGIT: f64 = 0.365;

/// Draws the figure as an SVG document that asks for the font [`FONT`].
pub(super) fn plot(figure: &Figure<'_>) -> String {
    let (time, values, layout) = lay_out(figure);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" \
         font-family=\"{FONT}\" font-size=\"{TEXT}\"><rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>",
        WIDTH / MILLIMETRE,
        HEIGHT / MILLIMETRE,
    );
    draw_axes(&time, &values, &layout, &mut svg);
    // The flattest curve is on top, where the others cannot hide it.
    let mut curves: Vec<_> = figure.curves.iter().collect();
    curves.sort_by(|one, other| other.span().total_cmp(&one.span()));
    for curve in curves {
        curve.draw(&mut svg, CURVE, |(t, value)| {
            (layout.x(time.along(t)), layout.y(values.along(value)))
        });
    }
    let titles =
        [time.title("<tspan font-style='italic'>t</tspan> (s)"), values.title(figure.label)];
    letter(figure, &titles, &layout, &mut svg);
    svg + "</svg>"
}

/// The edges of the field between the axes, and the lines of the caption.
struct Layout {
    left: f64,
    right: f64,
    above: f64,
    below: f64,
    caption: Vec<String>,
}

impl Layout {
    /// Returns the place of a part of the abscissa.
    fn x(&self, along: f64) -> f64 {
        self.left + (self.right - self.left) * along
    }

    /// Returns the place of a part of the ordinate.
    fn y(&self, along: f64) -> f64 {
        self.below + (self.above - self.below) * along
    }

    /// Returns the height of the caption.
    fn caption_height(&self) -> f64 {
        EDGE + self.caption.len() as f64 * CAPTION_ROW
    }
}

/// Returns the axes of a figure, and its layout, with margins that their labels need.
fn lay_out(figure: &Figure<'_>) -> (Axis, Axis, Layout) {
    let points = || figure.curves.iter().flat_map(|curve| curve.points);
    let end = points().fold(0.0, |end: f64, point| end.max(point.0));
    let values = Axis::around(points().map(|point| point.1), 4);
    let size = |width: f64| (width * TEXT).ceil();
    // The title has a line of its own.
    let labels = size(widest(values.labels().map(|(_, label)| label)));
    let left = EDGE + 1.25 * TEXT + EDGE + labels + GAP;
    // The label at the end of the axis is centred on it.
    let margin = 4.0 * MILLIMETRE;
    let time = Axis::along_line(0.0, end, 4, (WIDTH - left - margin) / TEXT);
    let last = time.labels().last().map_or(0.0, |(_, label)| width(label));
    let right = WIDTH - margin.max(size(last / 2.0) + EDGE);
    let caption = lines(&figure.caption, (WIDTH - 2.0 * EDGE) / SMALL);
    let below = HEIGHT - BELOW;
    let layout = Layout { left, right, above: 0.0, below, caption };
    let legend = figure.curves.len() as f64 * LEGEND_ROW;
    let above = layout.caption_height() + legend + MILLIMETRE;
    (time, values, Layout { above, ..layout })
}

// Writing to a string does not fail.

/// Draws the grid, the axes, their ticks and labels.
fn draw_axes(time: &Axis, values: &Axis, layout: &Layout, svg: &mut String) {
    let Layout { left, right, above, below, .. } = *layout;
    let (mut grid, mut labels) = (String::new(), String::new());
    let mut axes = format!("M{left:.0} {above:.0}V{below:.0}H{right:.0}");
    for (tick, label) in time.labels() {
        let x = layout.x(time.along(tick));
        let y = below + GAP + DIGIT * TEXT;
        let _ = write!(grid, "M{x:.0} {below:.0}V{above:.0}");
        let _ = write!(axes, "M{x:.0} {below:.0}v{MILLIMETRE}");
        let _ =
            write!(labels, "<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"middle\">{label}</text>");
    }
    for (tick, label) in values.labels() {
        let (x, y) = (left - GAP, layout.y(values.along(tick)));
        let _ = write!(grid, "M{left:.0} {y:.0}H{right:.0}");
        let _ = write!(axes, "M{left:.0} {y:.0}h-{MILLIMETRE}");
        let base = y + HALF_A_DIGIT * TEXT;
        let _ =
            write!(labels, "<text x=\"{x:.0}\" y=\"{base:.0}\" text-anchor=\"end\">{label}</text>");
    }
    for (path, colour) in [(grid, "#e1e1e1"), (axes, "black")] {
        let _ = write!(
            svg,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{RULE}\"/>"
        );
    }
    svg.push_str(&labels);
}

/// Writes the titles of the axes, the caption and the legend.
fn letter(figure: &Figure<'_>, [time, values]: &[String; 2], layout: &Layout, svg: &mut String) {
    let Layout { left, right, above, below, caption } = layout;
    let (middle, centre) = ((left + right) / 2.0, (above + below) / 2.0);
    let (bottom, side) = (HEIGHT - EDGE - TEXT / 4.0, EDGE + TEXT);
    let size = fitting(values, TEXT, HEIGHT - 2.0 * EDGE);
    // A long title is as high as the picture, and stands in its middle.
    let room = 2.0 * (centre.min(HEIGHT - centre) - EDGE);
    let centre = if width(values) * size > room { HEIGHT / 2.0 } else { centre };
    let _ = write!(
        svg,
        "<g text-anchor=\"middle\"><text x=\"{middle:.0}\" y=\"{bottom:.0}\">{time}</text>\
         <text transform=\"translate({side:.0} {centre:.0}) rotate(-90)\" font-size=\"{size:.0}\">{values}</text>"
    );
    for (row, line) in caption.iter().enumerate() {
        let y = EDGE + 0.8 * SMALL + row as f64 * CAPTION_ROW;
        let size = fitting(line, SMALL, WIDTH - 2.0 * EDGE);
        let _ = write!(
            svg,
            "<text x=\"{}\" y=\"{y:.0}\" font-size=\"{size:.0}\">{line}</text>",
            WIDTH / 2.0
        );
    }
    svg.push_str("</g>");
    for (row, curve) in figure.curves.iter().enumerate() {
        let y = layout.caption_height() + row as f64 * LEGEND_ROW + 230.0;
        let (from, to) = (*left, left + 900.0);
        curve.draw_entry(svg, 2.0 * CURVE, (from, to, 150.0), y);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::figures::all;
    use super::super::record::Record;
    use super::*;
    use crate::configuration::Config;
    use crate::pictures::curves::curve::Curve;
    use crate::pictures::lettering::checks::{collisions, texts};
    use heavytop::methods::{Formulation, SchemeName};

    /// The records of quantities that oscillate about `value` with this amplitude, up to time `end`.
    fn records(value: f64, amplitude: f64, end: f64) -> Vec<Record> {
        let pairs = [
            (Formulation::Collective, SchemeName::ExplicitMidpoint),
            (Formulation::Direct, SchemeName::ExplicitMidpoint),
            (Formulation::Collective, SchemeName::ImplicitMidpoint),
            (Formulation::Direct, SchemeName::ImplicitMidpoint),
        ];
        let record = |(formulation, scheme)| {
            let mut config = Config::default();
            config.integrator.formulation = Some(formulation);
            config.integrator.scheme = Some(scheme);
            (config.integrator.step, config.integrator.end) = (Some(end / 8.0), Some(end));
            let mut record = Record::new(&config.experiment().unwrap());
            for step in 0..=8_u64 {
                let phase = [0.0, 1.0, 0.3, -1.0][step as usize % 4];
                record.add(step, end * step as f64 / 8.0, [value + amplitude * phase; 4]);
            }
            record
        };
        pairs.into_iter().map(record).collect()
    }

    #[test]
    fn labels_are_apart_and_cut_at_no_scale() {
        for size in [1e-20, 2e-4, 193.0, 1e20] {
            for (value, amplitude) in
                [(0.0, 1.0), (1.0, 1e-3), (-1.0, 1e-8), (1.0, 0.0), (0.0, 0.0)]
            {
                for end in [2e-5, 2.0] {
                    let records = records(size * value, size * amplitude, end);
                    // Of the longest and the shortest title and legend.
                    for figure in all(&records).into_iter().skip(3).take(2) {
                        let drawing = plot(&figure);
                        let canvas = (WIDTH, HEIGHT);
                        let texts = texts(&drawing);
                        assert_eq!(
                            collisions(&drawing, canvas),
                            [""; 0],
                            "{size} {value} {texts:?}"
                        );
                        let has = |part: &str| texts.iter().any(|text| text.contains(part));
                        assert!(has("I = (2, 2, 1) kg m²") && has(" s, 0 to "), "{texts:?}");
                    }
                }
            }
        }
        // The unit of K is written as everywhere else, and the label has the power of ten.
        let records = records(0.0, 3e-20, 2.0);
        let drawing = plot(&all(&records)[3]);
        assert!(texts(&drawing).iter().any(|text| text == "K (10⁻²⁰ (kg m²/s)⁴)"));
    }

    #[test]
    fn curves_differ_without_colours() {
        let records = records(1.0, 1e-3, 2.0);
        for figure in all(&records) {
            let drawing = plot(&figure);
            let mut styles: Vec<_> = figure.curves.iter().map(Curve::dash_array).collect();
            for style in &styles {
                // In the curve and in the legend.
                let attribute = format!("stroke-dasharray=\"{style}\"");
                assert_eq!(drawing.matches(&attribute).count(), 2, "{}: {style}", figure.name);
            }
            let count = styles.len();
            styles.sort_unstable();
            styles.dedup();
            assert_eq!(styles.len(), count, "{}", figure.name);
        }
    }
}
