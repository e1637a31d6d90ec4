//! Drawing of a figure as SVG whose text is still text.

use super::figures::Figure;
use crate::Error;
use crate::pictures::Axis;
use crate::pictures::render::FONT;
use plotters::prelude::*;
use std::fmt::Write;

/// The width of one column of a journal, in units of 0.01 mm. The backend rounds to whole units, so that these must
/// be small.
const WIDTH: u32 = 8000;
const HEIGHT: u32 = 5800;

const MILLIMETRE: u32 = 100;
/// The size of the text, 7 pt.
const TEXT: u32 = 247;
/// The width of a digit of the text, which is also the distance of a label from its tick.
const DIGIT: u32 = 157;
/// The width of curves, 0.6 pt.
const CURVE: u32 = 21;
/// The width of rules, 0.4 pt.
const RULE: u32 = 14;
const LEGEND_ROW: u32 = 350;
const RIGHT: u32 = 4 * MILLIMETRE;
/// The space below the abscissa, for its labels and its title.
const BELOW: u32 = 8 * MILLIMETRE;
const GRID: RGBColor = RGBColor(225, 225, 225);

/// Draws the figure as an SVG document that asks for the font [`FONT`].
pub(super) fn plot(figure: &Figure<'_>) -> Result<String, Error> {
    let points = || figure.curves.iter().flat_map(|curve| curve.points);
    let end = points().fold(0.0, |end: f64, point| end.max(point.0));
    let time = Axis::new(0.0, end, 4);
    let values = Axis::around(points().map(|point| point.1), 4);
    let left = 650 + DIGIT * values.label_length().min(15);

    let mut svg = String::new();
    draw(figure, time, values, left, &mut svg).map_err(|e| Error::Figure(e.to_string()))?;
    let body = svg.split_once('>').map_or("", |(_, body)| body);
    let body = body.trim_end().trim_end_matches("</svg>");
    // Round corners, and digits centred on their ticks.
    let body = body.replace("<polyline ", "<polyline stroke-linejoin=\"round\" ");
    let body = body.replace("dy=\"0.5ex\"", "dy=\"0.365em\"");
    let lettering = lettering(figure, left);
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" \
         viewBox=\"0 0 {WIDTH} {HEIGHT}\">{body}{lettering}</svg>",
        WIDTH / MILLIMETRE,
        HEIGHT / MILLIMETRE,
    ))
}

fn legend_height(figure: &Figure<'_>) -> u32 {
    figure.curves.len() as u32 * LEGEND_ROW + MILLIMETRE
}

type Failure = Box<dyn std::error::Error>;

/// Draws the axes and the curves.
fn draw(
    figure: &Figure<'_>,
    time: Axis,
    values: Axis,
    left: u32,
    svg: &mut String,
) -> Result<(), Failure> {
    let area = SVGBackend::with_string(svg, (WIDTH, HEIGHT)).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin_top(legend_height(figure))
        .margin_right(RIGHT)
        .x_label_area_size(BELOW)
        .y_label_area_size(left)
        .build_cartesian_2d(time, values)?;
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

/// Writes what plotters cannot write: titles in two fonts, and a legend outside the axes.
fn lettering(figure: &Figure<'_>, left: u32) -> String {
    let middle = (left + WIDTH - RIGHT) / 2;
    let centre = (legend_height(figure) + HEIGHT - BELOW) / 2;
    let (bottom, side) = (HEIGHT - 120, 320);
    let mut text = format!(
        "<g font-family=\"{FONT}\" font-size=\"{TEXT}\" text-anchor=\"middle\">\
         <text x=\"{middle}\" y=\"{bottom}\"><tspan font-style='italic'>t</tspan> (s)</text>\
         <text transform=\"translate({side} {centre}) rotate(-90)\">{}</text></g>\
         <g font-family=\"{FONT}\" font-size=\"{TEXT}\">",
        figure.label
    );
    for (row, curve) in figure.curves.iter().enumerate() {
        let RGBColor(red, green, blue) = curve.colour;
        let y = row as u32 * LEGEND_ROW + 230;
        let (end, start, base) = (left + 700, left + 850, y + 88);
        // Writing to a string does not fail.
        let _ = write!(
            text,
            "<line x1=\"{left}\" y1=\"{y}\" x2=\"{end}\" y2=\"{y}\" stroke-width=\"{}\" \
             stroke=\"rgb({red},{green},{blue})\"/><text x=\"{start}\" y=\"{base}\">{}</text>",
            2 * CURVE,
            curve.name
        );
    }
    text + "</g>"
}
