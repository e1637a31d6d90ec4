//! Cells in colours by value, and the scale beside them.

use super::canvas::{Area, PIXEL, TEXT, text};
use super::colours::diverging;
use super::curves::{Axes, Chart, axes, label};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::error::Error;
use svg_pictures::SvgElement;

/// Draws columns × rows cells in a chart, between the left upper and the right lower corner; the top row is the first.
///
/// # Errors
/// Returns the reason if the cells cannot be encoded.
pub fn cells(
    chart: &mut Chart<'_>,
    [columns, rows]: [usize; 2],
    colours: impl Iterator<Item = [u8; 3]>,
) -> Result<(), Box<dyn Error>> {
    let (x, y) = (chart.plotting_area().get_x_range(), chart.plotting_area().get_y_range());
    let size = [columns.try_into()?, rows.try_into()?];
    let cells = SvgElement::cells([(x.start, y.end), (x.end, y.start)], size, colours)?;
    chart.draw_series([cells])?;
    Ok(())
}

/// Values of sites in a row, against time.
pub struct Sites<'a> {
    pub title: &'a str,
    /// The time of the last value; the first is that at t = 0.
    pub time: f64,
    /// The name of the numbers 1 to `count` of the sites.
    pub name: &'a str,
    pub count: usize,
}

impl Sites<'_> {
    /// Draws the axes, and the values f(site, instant) from −most to most.
    ///
    /// # Errors
    /// Returns the reason of the library for drawing.
    pub fn draw(
        &self,
        area: &Area,
        instants: usize,
        f: impl Fn(usize, usize) -> f64,
        most: f64,
    ) -> Result<(), Box<dyn Error>> {
        let heights = 0.5..self.count as f64 + 0.5;
        let frame = Axes {
            title: self.title,
            x: ("t (no unit)", 0.0..self.time),
            y: (self.name, heights),
            grid: false,
        };
        let mut chart = axes(area, &frame, &[])?;
        let rows = (0..self.count).rev();
        let colours = rows.flat_map(|i| (0..instants).map(move |n| (i, n)));
        let colours = colours.map(|(i, n)| diverging(f(i, n) / most));
        cells(&mut chart, [instants, self.count], colours)
    }
}

/// Draws the scale of [`diverging`] colours from −most to most along the left edge of an area.
///
/// # Errors
/// Returns the reason of the library for drawing.
pub fn scale(
    area: &Area,
    name: &str,
    most: f64,
    [top, bottom]: [i32; 2],
) -> Result<(), Box<dyn Error>> {
    let [left, right] = [8 * PIXEL, 28 * PIXEL];
    let height = |part: f64| bottom + ((f64::from(top - bottom)) * part) as i32;
    let shades = (0..200).rev().map(|n| diverging((f64::from(n) - 99.5) / 100.0));
    area.draw(&SvgElement::cells([(left, top), (right, bottom)], [1, 200], shades)?)?;
    area.draw(&Rectangle::new([(left, bottom), (right, top)], BLACK.stroke_width(PIXEL as u32)))?;
    for part in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let style = text(TEXT * 0.94, &BLACK, (HPos::Left, VPos::Center));
        let value = ((2.0 * part - 1.0) * most * 100.0).round() / 100.0;
        let y = height(part);
        area.draw(&PathElement::new(
            [(right, y), (right + 5 * PIXEL, y)],
            BLACK.stroke_width(PIXEL as u32),
        ))?;
        area.draw(&Text::new(label(&value), (right + 9 * PIXEL, y), style))?;
    }
    let style = text(TEXT * 0.94, &BLACK, (HPos::Left, VPos::Center));
    area.draw(&Text::new(name, (left, top - 18 * PIXEL), style))?;
    Ok(())
}
