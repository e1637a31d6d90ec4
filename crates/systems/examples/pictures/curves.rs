//! Curves over axes with names, units and a key.

use super::canvas::{Area, PIXEL, TEXT, text};
use super::colours::GRID;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::error::Error;
use std::ops::Range;
use svg_pictures::SvgCanvas;

/// Axes on which an example draws.
pub type Chart<'a> = ChartContext<'a, SvgCanvas, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// A curve with a name for the key.
pub struct Curve {
    /// The name in the key; a curve without a name is not in it.
    pub name: String,
    pub colour: RGBColor,
    pub points: Vec<(f64, f64)>,
}

/// The axes of a chart: name with unit, and range.
pub struct Axes<'a> {
    pub title: &'a str,
    pub x: (&'a str, Range<f64>),
    pub y: (&'a str, Range<f64>),
    /// Whether lines are drawn at the numbers of the axes.
    pub grid: bool,
}

const LEFT: i32 = 92;
const BELOW: i32 = 56;
const EDGE: i32 = 14;
const KEY: i32 = 30;

/// Returns the least range that holds all numbers that are finite, with 4 % of room on both sides.
pub fn around(values: impl Iterator<Item = f64>) -> Range<f64> {
    let finite = values.filter(|value| value.is_finite());
    let (low, high) =
        finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return 0.0..1.0;
    }
    let room = (0.04 * (high - low)).max(1e-9 * high.abs()).max(1e-12);
    low - room..high + room
}

/// Returns a label with a true minus sign, and without digits that rounding adds.
pub fn label(value: &f64) -> String {
    let rounded = (value * 1e9).round() / 1e9 + 0.0;
    format!("{rounded}").replace('-', "−")
}

/// Draws axes with a title, and with a key of names in their colours above the frame.
///
/// # Errors
/// Returns the reason of the library for drawing.
pub fn axes<'a>(
    area: &'a Area,
    axes: &Axes<'_>,
    key: &[(&str, RGBColor)],
) -> Result<Chart<'a>, Box<dyn Error>> {
    let top = if axes.title.is_empty() { 4 } else { KEY } + if key.is_empty() { 0 } else { KEY };
    let mut chart = ChartBuilder::on(area)
        .margin_top(top * PIXEL)
        .margin_left(EDGE * PIXEL)
        .margin_right(28 * PIXEL)
        .margin_bottom(4 * PIXEL)
        .x_label_area_size(BELOW * PIXEL)
        .y_label_area_size((LEFT - EDGE) * PIXEL)
        .build_cartesian_2d(axes.x.1.clone(), axes.y.1.clone())?;
    let style = |anchor| text(TEXT * 0.94, &BLACK, anchor);
    let mut mesh = chart.configure_mesh();
    if !axes.grid {
        mesh.disable_mesh();
    }
    mesh.x_desc(axes.x.0)
        .y_desc(axes.y.0)
        .x_labels(7)
        .y_labels(6)
        .max_light_lines(0)
        .x_label_formatter(&label)
        .y_label_formatter(&label)
        .bold_line_style(GRID.stroke_width(PIXEL as u32))
        .axis_style(BLACK.stroke_width(PIXEL as u32))
        .set_all_tick_mark_size(5 * PIXEL)
        .label_style(style((HPos::Center, VPos::Center)))
        .axis_desc_style(style((HPos::Center, VPos::Center)))
        .draw()?;
    let middle = (LEFT * PIXEL + area.dim_in_pixel().0 as i32 - 28 * PIXEL) / 2;
    let style = text(TEXT, &BLACK, (HPos::Center, VPos::Center));
    area.draw(&Text::new(axes.title, (middle, KEY * PIXEL / 2), style))?;
    draw_key(area, key, (LEFT * PIXEL, (top - KEY / 2) * PIXEL))?;
    Ok(chart)
}

/// Draws names after short lines in their colours, in a row.
///
/// # Errors
/// Returns the reason of the library for drawing.
pub fn draw_key(
    area: &Area,
    key: &[(&str, RGBColor)],
    (mut x, y): (i32, i32),
) -> Result<(), Box<dyn Error>> {
    for (name, colour) in key {
        let end = x + 34 * PIXEL;
        area.draw(&PathElement::new([(x, y), (end, y)], colour.stroke_width(4 * PIXEL as u32)))?;
        let style = text(TEXT * 0.94, &BLACK, (HPos::Left, VPos::Center));
        area.draw_text(name, &style, (end + 8 * PIXEL, y))?;
        x = end + 30 * PIXEL + area.estimate_text_size(name, &style)?.0 as i32;
    }
    Ok(())
}

/// Draws curves with their key, over axes that hold all of them. A curve has a gap where a value is NaN.
///
/// # Errors
/// Returns the reason of the library for drawing.
pub fn curves(
    area: &Area,
    title: &str,
    [x, y]: [&str; 2],
    curves: &[Curve],
) -> Result<(), Box<dyn Error>> {
    let all = || curves.iter().flat_map(|curve| &curve.points);
    let first = all().map(|point| point.0).fold(f64::INFINITY, f64::min);
    let last = all().map(|point| point.0).fold(f64::NEG_INFINITY, f64::max);
    let named = curves.iter().filter(|curve| !curve.name.is_empty());
    let key: Vec<_> = named.map(|curve| (curve.name.as_str(), curve.colour)).collect();
    let range = around(all().map(|point| point.1));
    let mut chart =
        axes(area, &Axes { title, x: (x, first..last), y: (y, range), grid: true }, &key)?;
    for curve in curves {
        let style = curve.colour.stroke_width(2 * PIXEL as u32);
        for piece in curve.points.split(|point| point.1.is_nan()) {
            chart.draw_series(LineSeries::new(piece.iter().copied(), style))?;
        }
    }
    Ok(())
}
