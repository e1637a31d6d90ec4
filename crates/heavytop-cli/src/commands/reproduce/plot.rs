//! Drawing of a figure as SVG whose text is still text.

use super::figures::{Curve, Figure};
use crate::Error;
use crate::pictures::Axis;
use crate::pictures::lettering::{FONT, fitting, lines, widest, width};
use plotters::prelude::*;
use std::fmt::Write;

/// The width of one column of a journal, in units of 0.01 mm. The backend rounds to whole units, so that these must
/// be small.
const WIDTH: u32 = 8000;
const HEIGHT: u32 = 5800;

const MILLIMETRE: u32 = 100;
/// The size of the text, 7 pt.
const TEXT: u32 = 247;
/// The size of the caption, 5.5 pt.
const SMALL: u32 = 194;
/// The width of curves, 0.6 pt.
const CURVE: u32 = 21;
/// The width of rules, 0.4 pt.
const RULE: u32 = 14;
const LEGEND_ROW: u32 = 350;
const CAPTION_ROW: u32 = 250;
/// The distance of titles and captions from the edge.
const EDGE: u32 = 90;
/// The space below the abscissa, for its labels and its title.
const BELOW: u32 = 8 * MILLIMETRE;
const GRID: RGBColor = RGBColor(225, 225, 225);

/// Draws the figure as an SVG document that asks for the font [`FONT`].
pub(super) fn plot(figure: &Figure<'_>) -> Result<String, Error> {
    let points = || figure.curves.iter().flat_map(|curve| curve.points);
    let end = points().fold(0.0, |end: f64, point| end.max(point.0));
    let values = Axis::around(points().map(|point| point.1), 4);
    let size = |width: f64| (width * f64::from(TEXT)).ceil() as u32;
    // The title has a line of its own, and plotters puts labels a digit away from their ticks.
    let labels = size(widest(values.labels().map(|(_, label)| label)) + 0.64);
    let left = EDGE + TEXT * 5 / 4 + EDGE + labels + MILLIMETRE;
    // The label at the end of the axis is centred on it.
    let right = 4 * MILLIMETRE;
    let length = f64::from(WIDTH - left - right) / f64::from(TEXT);
    let time = Axis::along_line(0.0, end, 4, length);
    let last = time.labels().last().map_or(0.0, |(_, label)| width(label));
    let right = right.max(size(last / 2.0) + EDGE);
    let caption = lines(&figure.caption, f64::from(WIDTH - 2 * EDGE) / f64::from(SMALL));
    let layout = Layout { left, right, caption };

    let mut svg = String::new();
    draw(figure, &time, &values, &layout, &mut svg).map_err(|e| Error::Figure(e.to_string()))?;
    let body = svg.split_once('>').map_or("", |(_, body)| body);
    let body = body.trim_end().trim_end_matches("</svg>");
    // Round corners, and digits centred on their ticks.
    let body = body.replace("<polyline ", "<polyline stroke-linejoin=\"round\" ");
    let body = body.replace("dy=\"0.5ex\"", "dy=\"0.365em\"");
    // plotters would write each dash as a path of its own, a million of them where a long curve oscillates.
    let body = figure.curves.iter().fold(body, |body, curve| {
        let RGBColor(red, green, blue) = curve.colour;
        let stroke = format!("stroke=\"#{red:02X}{green:02X}{blue:02X}\"");
        body.replace(&stroke, &format!("{stroke} stroke-dasharray=\"{}\"", dashes(curve)))
    });
    let titles =
        [time.title("<tspan font-style='italic'>t</tspan> (s)"), values.title(figure.label)];
    let lettering = lettering(figure, &titles, &layout);
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" \
         viewBox=\"0 0 {WIDTH} {HEIGHT}\">{body}{lettering}</svg>",
        WIDTH / MILLIMETRE,
        HEIGHT / MILLIMETRE,
    ))
}

/// The margins of a figure, and the lines of its caption.
struct Layout {
    left: u32,
    right: u32,
    caption: Vec<String>,
}

impl Layout {
    /// Returns the height of the caption.
    fn caption_height(&self) -> u32 {
        EDGE + self.caption.len() as u32 * CAPTION_ROW
    }

    /// Returns the height of the caption and the legend.
    fn above(&self, figure: &Figure<'_>) -> u32 {
        self.caption_height() + figure.curves.len() as u32 * LEGEND_ROW + MILLIMETRE
    }
}

/// Returns the dashes of a curve as SVG writes them.
fn dashes(curve: &Curve<'_>) -> &'static str {
    if curve.dashes.is_empty() { "none" } else { curve.dashes }
}

type Failure = Box<dyn std::error::Error>;

/// Draws the axes and the curves.
fn draw(
    figure: &Figure<'_>,
    time: &Axis,
    values: &Axis,
    layout: &Layout,
    svg: &mut String,
) -> Result<(), Failure> {
    let area = SVGBackend::with_string(svg, (WIDTH, HEIGHT)).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin_top(layout.above(figure))
        .margin_right(layout.right)
        .x_label_area_size(BELOW)
        .y_label_area_size(layout.left)
        .build_cartesian_2d(time.clone(), values.clone())?;
    chart
        .configure_mesh()
        .bold_line_style(GRID.stroke_width(RULE))
        .axis_style(BLACK.stroke_width(RULE))
        .set_all_tick_mark_size(MILLIMETRE)
        // The backend divides the size by 1.24.
        .label_style((FONT, f64::from(TEXT) * 1.24))
        .draw()?;
    // The flattest curve is on top, where the others cannot hide it.
    let mut curves: Vec<_> = figure.curves.iter().collect();
    curves.sort_by(|one, other| other.span().total_cmp(&one.span()));
    for curve in curves {
        let finite = curve.points.iter().copied().filter(|point| point.1.is_finite());
        chart.draw_series(LineSeries::new(finite, curve.colour.stroke_width(CURVE)))?;
    }
    area.present()?;
    Ok(())
}

/// Writes what plotters cannot write: titles in two fonts, and a caption and a legend outside the axes.
fn lettering(figure: &Figure<'_>, [time, values]: &[String; 2], layout: &Layout) -> String {
    let Layout { left, right, caption } = layout;
    let (above, below) = (layout.above(figure), HEIGHT - BELOW);
    let (middle, centre) = ((left + WIDTH - right) / 2, (above + below) / 2);
    let (bottom, side) = (HEIGHT - EDGE - TEXT / 4, EDGE + TEXT);
    let size = fitting(values, f64::from(TEXT), f64::from(HEIGHT - 2 * EDGE));
    // A long title is as high as the picture, and stands in its middle.
    let room = f64::from(2 * (centre.min(HEIGHT - centre) - EDGE));
    let centre = if width(values) * size > room { HEIGHT / 2 } else { centre };
    let mut text = format!(
        "<g font-family=\"{FONT}\" font-size=\"{TEXT}\" text-anchor=\"middle\">\
         <text x=\"{middle}\" y=\"{bottom}\">{time}</text>\
         <text transform=\"translate({side} {centre}) rotate(-90)\" font-size=\"{size:.0}\">{values}</text></g>\
         <g font-family=\"{FONT}\" font-size=\"{TEXT}\">"
    );
    // Writing to a string does not fail.
    for (row, line) in caption.iter().enumerate() {
        let y = EDGE + SMALL * 4 / 5 + row as u32 * CAPTION_ROW;
        let size = fitting(line, f64::from(SMALL), f64::from(WIDTH - 2 * EDGE));
        let _ = write!(
            text,
            "<text x=\"{}\" y=\"{y}\" font-size=\"{size:.0}\" text-anchor=\"middle\">{line}</text>",
            WIDTH / 2
        );
    }
    for (row, curve) in figure.curves.iter().enumerate() {
        let RGBColor(red, green, blue) = curve.colour;
        let y = layout.caption_height() + row as u32 * LEGEND_ROW + 230;
        let (end, start, base) = (left + 900, left + 1050, y + 88);
        let _ = write!(
            text,
            "<line x1=\"{left}\" y1=\"{y}\" x2=\"{end}\" y2=\"{y}\" stroke-width=\"{}\" \
             stroke=\"rgb({red},{green},{blue})\" stroke-dasharray=\"{}\"/>\
             <text x=\"{start}\" y=\"{base}\">{}</text>",
            2 * CURVE,
            dashes(curve),
            curve.name
        );
    }
    text + "</g>"
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::figures::all;
    use super::super::record::Record;
    use super::*;
    use crate::configuration::Config;
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
    #[ignore = "long"]
    fn labels_are_apart_and_cut_at_no_scale() {
        for size in [1e-20, 2e-4, 193.0, 1e20] {
            for (value, amplitude) in
                [(0.0, 1.0), (1.0, 1e-3), (-1.0, 1e-8), (1.0, 0.0), (0.0, 0.0)]
            {
                for end in [2e-5, 2.0] {
                    let records = records(size * value, size * amplitude, end);
                    // Of the longest and the shortest title and legend.
                    for figure in all(&records).into_iter().skip(3).take(2) {
                        let drawing = plot(&figure).unwrap();
                        let canvas = (f64::from(WIDTH), f64::from(HEIGHT));
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
        let drawing = plot(&all(&records)[3]).unwrap();
        assert!(texts(&drawing).iter().any(|text| text == "K (10⁻²⁰ (kg m²/s)⁴)"));
    }

    #[test]
    fn curves_differ_without_colours() {
        let records = records(1.0, 1e-3, 2.0);
        for figure in all(&records) {
            let drawing = plot(&figure).unwrap();
            let mut styles: Vec<_> = figure.curves.iter().map(dashes).collect();
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
