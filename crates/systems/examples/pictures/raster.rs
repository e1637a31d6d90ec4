//! Cells in colours by value, and the scale beside them.

use super::canvas::{Area, Image, PIXEL, TEXT, text};
use super::colours::diverging;
use super::curves::{Axes, axes, label};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::error::Error;

/// Returns the image of columns × rows cells between the given corners, the top row first.
///
/// # Errors
/// Returns the reason if the cells are not as many, or cannot be encoded.
pub fn image(
    corners: [i32; 4],
    [columns, rows]: [usize; 2],
    colours: impl Iterator<Item = [u8; 3]>,
) -> Result<Image, Box<dyn Error>> {
    let pixels: Vec<u8> = colours.flatten().collect();
    let mut png = Vec::new();
    let mut encoder = png::Encoder::new(&mut png, columns.try_into()?, rows.try_into()?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(Image { corners, cells: BASE64_STANDARD.encode(png) })
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
    /// Draws the axes, and returns the image of the values f(site, instant) from −most to most.
    ///
    /// # Errors
    /// Returns the reason of the library for drawing.
    pub fn draw(
        &self,
        area: &Area<'_>,
        instants: usize,
        f: impl Fn(usize, usize) -> f64,
        most: f64,
    ) -> Result<Image, Box<dyn Error>> {
        let heights = 0.5..self.count as f64 + 0.5;
        let frame = Axes {
            title: self.title,
            x: ("t (no unit)", 0.0..self.time),
            y: (self.name, heights),
            grid: false,
        };
        let chart = axes(area, &frame, &[])?;
        // The range is relative to the whole picture.
        let (x, y) = chart.plotting_area().get_pixel_range();
        let rows = (0..self.count).rev();
        let colours = rows.flat_map(|i| (0..instants).map(move |n| (i, n)));
        let colours = colours.map(|(i, n)| diverging(f(i, n) / most));
        image([x.start, y.start, x.end, y.end], [instants, self.count], colours)
    }
}

/// Draws the scale of [`diverging`] colours from −most to most along the left edge of an area.
///
/// # Errors
/// Returns the reason of the library for drawing.
pub fn scale(
    area: &Area<'_>,
    name: &str,
    most: f64,
    [top, bottom]: [i32; 2],
) -> Result<(), Box<dyn Error>> {
    const STRIPES: i32 = 100;
    let [left, right] = [8 * PIXEL, 28 * PIXEL];
    let height = |part: f64| bottom + ((f64::from(top - bottom)) * part) as i32;
    for stripe in 0..STRIPES {
        let part = f64::from(stripe) / f64::from(STRIPES);
        let [red, green, blue] = diverging(2.0 * part - 1.0);
        // Each stripe goes up to the top, so that no gaps remain between stripes.
        let corners = [(left, height(part)), (right, top)];
        area.draw(&Rectangle::new(corners, RGBColor(red, green, blue).filled()))?;
    }
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
