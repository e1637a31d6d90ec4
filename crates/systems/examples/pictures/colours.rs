//! Colours that readers with any colour vision tell apart.
//!
//! Source: M. Okabe & K. Ito, *Color universal design* (2008), for the curves.

use plotters::style::RGBColor;

pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const RED: RGBColor = RGBColor(213, 94, 0);
pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
pub const DARK: RGBColor = RGBColor(40, 40, 40);
pub const GREY: RGBColor = RGBColor(150, 150, 150);
pub const GRID: RGBColor = RGBColor(225, 225, 225);

/// The colours of curves, in order.
pub const CURVES: [RGBColor; 5] = [BLUE, RED, ORANGE, DARK, GREY];

/// Returns the colour of a number from −1 to 1: blue, white, red. A number outside has the colour of the nearer end.
pub fn diverging(value: f64) -> [u8; 3] {
    let (low, high) = ([33.0, 102.0, 172.0], [178.0, 24.0, 43.0]);
    let end: [f64; 3] = if value < 0.0 { low } else { high };
    let part = value.abs().min(1.0);
    end.map(|c| (247.0 + part * (c - 247.0)).round() as u8)
}
