//! A curve of a picture, which differs from others by its colour and by its dashes: [`Curve`].

use crate::errors::Error;
use crate::pictures::charts::scaled_chart::Chart;
use crate::pictures::charts::sheet::{Area, text};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use svg_pictures::SvgElement;

// The colours of Okabe and Ito, which readers with all kinds of colour vision tell apart, and a gray. Dashes tell the
// curves apart in black and white. Source: M. Okabe & K. Ito, *Color Universal Design* (2008).
pub(crate) const BLUE: RGBColor = RGBColor(0, 114, 178);
pub(crate) const GREEN: RGBColor = RGBColor(0, 158, 115);
pub(crate) const RED: RGBColor = RGBColor(213, 94, 0);
pub(crate) const GRAY: RGBColor = RGBColor(85, 85, 85);
const PURPLE: RGBColor = RGBColor(204, 121, 167);
const ORANGE: RGBColor = RGBColor(230, 159, 0);

/// The width of curves, in units of 0.01 mm; in legends they are twice as wide.
const WIDTH: u32 = 21;
/// The length of the lines of a legend, and the gap beside them.
const ENTRY: [i32; 2] = [600, 120];

/// The dashes and gaps of curves, in units of 0.01 mm.
pub(crate) const WHOLE: &str = "";
pub(crate) const DASHED: &str = "150 60";
pub(crate) const DOTTED: &str = "35 35";

/// The colours and dashes of curves that are drawn together, in their order.
pub(crate) const STYLES: [(RGBColor, &str); 6] = [
    (BLUE, WHOLE),
    (RED, DASHED),
    (GREEN, DOTTED),
    (PURPLE, "150 40 35 40"),
    (ORANGE, "70 50"),
    (GRAY, "260 60"),
];

/// A curve with its place in the legend.
#[derive(Clone, Debug)]
pub(crate) struct Curve<'a> {
    /// The name of the curve.
    pub name: String,
    /// The colour of the curve.
    pub colour: RGBColor,
    /// The dashes and gaps, in units of 0.01 mm; empty for a whole line.
    pub dashes: &'static str,
    /// The points, such as (t, quantity).
    pub points: &'a [(f64, f64)],
}

impl Curve<'_> {
    /// Returns the highest value less the lowest.
    pub fn span(&self) -> f64 {
        let values = || self.points.iter().map(|point| point.1);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    }

    /// Draws the curve where `place` puts its points in the chart. It has a gap at a point that is no number, and a dot for a
    /// point that is alone.
    ///
    /// # Errors
    /// If plotters cannot draw them.
    pub fn draw(
        &self,
        chart: &mut Chart<'_>,
        place: impl Fn((f64, f64)) -> (f64, f64),
    ) -> Result<(), Error> {
        let points: Vec<(f64, f64)> = self.points.iter().copied().map(place).collect();
        for piece in points.split(|(x, y)| !(x.is_finite() && y.is_finite())) {
            match piece {
                [] => {}
                [alone] => {
                    let dot = Circle::new(*alone, 2 * WIDTH as i32, self.colour.filled());
                    chart.draw_series([dot])?;
                }
                _ => {
                    let style = self.colour.stroke_width(WIDTH);
                    chart.draw_series([SvgElement::dashed(piece, style, self.dashes)])?;
                }
            }
        }
        Ok(())
    }

    /// Draws the entry of a legend: a line from a place in an area to the right, and the name beside it in
    /// text of this size.
    ///
    /// # Errors
    /// If the name cannot be drawn.
    pub fn draw_entry(&self, area: &Area, (left, y): (i32, i32), size: f64) -> Result<(), Error> {
        let (right, style) = (left + ENTRY[0], self.colour.stroke_width(2 * WIDTH));
        area.draw(&SvgElement::dashed([(left, y), (right, y)], style, self.dashes))?;
        let style = text(size, HPos::Left, VPos::Center);
        area.draw_text(&self.name, &style, (right + ENTRY[1], y))?;
        Ok(())
    }
}

/// Returns the width of an entry of a legend whose name is so wide.
pub(crate) fn entry_width(name: f64) -> i32 {
    ENTRY[0] + ENTRY[1] + name as i32
}
