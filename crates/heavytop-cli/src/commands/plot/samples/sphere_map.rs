//! The sphere in Mollweide's projection, which conserves areas: [`SphereMap`].
//!
//! With x and y from −1 to 1 and sin α = y, the latitude is asin((2α + sin 2α)/π) and the longitude πx/cos α. Source:
//! J. P. Snyder, *Map Projections: A Working Manual* (1987), p. 251.

use crate::pictures::{Frame, Scale};
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;

/// The height of a picture, in units of 0.01 mm: a map is half as high as wide.
const HEIGHT: f64 = 6_900.0;

/// The place of the map of a sphere in its frame.
pub(super) struct SphereMap {
    pub frame: Frame,
    pub centre: [f64; 2],
    /// Half of the height.
    pub radius: f64,
}

impl SphereMap {
    /// Creates the map in a frame with this caption and this bar of colours.
    pub fn new(caption: &[String], bar: Option<Scale>) -> Self {
        let blank = Scale { ticks: Vec::new(), title: String::new(), line: None };
        let frame = Frame::of_height(HEIGHT, caption, blank, bar);
        let centre = [(frame.left + frame.right) / 2.0, (frame.top + frame.bottom) / 2.0];
        let radius =
            0.985 * ((frame.right - frame.left) / 4.0).min((frame.bottom - frame.top) / 2.0);
        Self { frame, centre, radius }
    }

    /// Returns the place of a latitude and a longitude, in radians.
    pub fn place(&self, latitude: f64, longitude: f64) -> [f64; 2] {
        // Newton's iteration for 2α + sin 2α = π sin(latitude); at the poles, where the derivative vanishes, α is known.
        let mut angle = latitude;
        if latitude.abs() < FRAC_PI_2 - 1e-9 {
            for _ in 0..30 {
                let excess = 2.0 * angle + (2.0 * angle).sin() - PI * latitude.sin();
                angle -= excess / (2.0 + 2.0 * (2.0 * angle).cos());
            }
        }
        let [x, y] = [2.0 * longitude / PI * angle.cos(), angle.sin()];
        [self.centre[0] + self.radius * x, self.centre[1] - self.radius * y]
    }

    /// Returns the beginning of the drawing.
    pub fn begin() -> String {
        Frame::begin_of_height(HEIGHT)
    }

    /// Draws the outline, and parallels and meridians every 30 and 60 degrees.
    pub fn draw(&self, svg: &mut String) {
        let mut path = String::new();
        let mut line = |points: &mut dyn Iterator<Item = [f64; 2]>| {
            for (number, [x, y]) in points.enumerate() {
                // Writing to a string does not fail.
                let _ = write!(path, "{}{x:.0} {y:.0}", if number == 0 { 'M' } else { 'L' });
            }
        };
        for degrees in [-60.0_f64, -30.0, 0.0, 30.0, 60.0] {
            let latitude = degrees.to_radians();
            line(&mut [-PI, PI].into_iter().map(|longitude| self.place(latitude, longitude)));
        }
        for degrees in [-120.0_f64, -60.0, 0.0, 60.0, 120.0] {
            let along = (0..=60).map(|i| PI * (f64::from(i) / 60.0 - 0.5));
            line(&mut along.map(|latitude| self.place(latitude, degrees.to_radians())));
        }
        let ([x, y], radius) = (self.centre, self.radius);
        let _ = write!(
            svg,
            "<path d=\"{path}\" fill=\"none\" stroke=\"#808080\" stroke-width=\"8\"/>\
             <ellipse cx=\"{x:.0}\" cy=\"{y:.0}\" rx=\"{:.0}\" ry=\"{radius:.0}\" fill=\"none\" \
             stroke=\"black\" stroke-width=\"14\"/>",
            2.0 * radius
        );
    }

    /// Draws the caption and the bar of colours, and completes the drawing.
    pub fn complete(&self, mut svg: String) -> String {
        let title =
            "Mollweide's projection; lines every 30° of latitude and 60° of longitude".into();
        self.frame.draw(&mut svg, &Scale { ticks: Vec::new(), title, line: None });
        svg + "</svg>"
    }
}
