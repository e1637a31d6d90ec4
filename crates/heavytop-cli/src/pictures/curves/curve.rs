//! A curve of a picture, which differs from others by its colour and by its dashes: [`Curve`].

use std::fmt::Write;

// The colours of Okabe and Ito, which readers with all kinds of colour vision tell apart, and a gray. Dashes tell the
// curves apart in black and white. Source: M. Okabe & K. Ito, *Color Universal Design* (2008).
pub(crate) const BLUE: &str = "#0072b2";
pub(crate) const GREEN: &str = "#009e73";
pub(crate) const RED: &str = "#d55e00";
pub(crate) const GRAY: &str = "#555555";
const PURPLE: &str = "#cc79a7";
const ORANGE: &str = "#e69f00";

/// The dashes and gaps of curves, in units of 0.01 mm.
pub(crate) const WHOLE: &str = "";
pub(crate) const DASHED: &str = "150 60";
pub(crate) const DOTTED: &str = "35 35";

/// The colours and dashes of curves that are drawn together, in their order.
pub(crate) const STYLES: [(&str, &str); 6] = [
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
    pub colour: &'static str,
    /// The dashes and gaps, in units of 0.01 mm; empty for a whole line.
    pub dashes: &'static str,
    /// The points, such as (t, quantity).
    pub points: &'a [(f64, f64)],
}

// Writing to a string does not fail.
impl Curve<'_> {
    /// Returns the highest value less the lowest.
    pub fn span(&self) -> f64 {
        let values = || self.points.iter().map(|point| point.1);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    }

    /// Returns the dashes as SVG writes them.
    pub fn dash_array(&self) -> &'static str {
        if self.dashes.is_empty() { "none" } else { self.dashes }
    }

    /// Draws the points that are numbers, joined by a line of this width, where `place` puts them.
    pub fn draw(&self, svg: &mut String, width: f64, place: impl Fn((f64, f64)) -> (f64, f64)) {
        let _ = write!(
            svg,
            "<polyline fill=\"none\" stroke-linejoin=\"round\" stroke=\"{}\" stroke-width=\"{width}\" \
             stroke-dasharray=\"{}\" points=\"",
            self.colour,
            self.dash_array()
        );
        for point in self.points.iter().filter(|point| point.1.is_finite()) {
            let (x, y) = place(*point);
            let _ = write!(svg, "{x:.0},{y:.0} ");
        }
        svg.push_str("\"/>");
    }

    /// Draws the entry of the legend: a line of this width from `left` to `right`, and the name `gap` beside it.
    pub fn draw_entry(
        &self,
        svg: &mut String,
        width: f64,
        (left, right, gap): (f64, f64, f64),
        y: f64,
    ) {
        let (start, base) = (right + gap, y + 88.0);
        let _ = write!(
            svg,
            "<path d=\"M{left:.0} {y:.0}H{right:.0}\" stroke=\"{}\" stroke-width=\"{width}\" \
             stroke-dasharray=\"{}\"/><text x=\"{start:.0}\" y=\"{base:.0}\">{}</text>",
            self.colour,
            self.dash_array(),
            self.name
        );
    }
}
