//! The sphere in Mollweide's projection, which conserves areas: [`SphereMap`].
//!
//! With x and y from −1 to 1 and sin α = y, the latitude is asin((2α + sin 2α)/π) and the longitude πx/cos α. Source:
//! J. P. Snyder, *Map Projections: A Working Manual* (1987), p. 251.

use crate::errors::Error;
use crate::pictures::charts::scaled_chart::{Chart, rule};
use crate::pictures::{Frame, Scale};
use plotters::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The height of a picture, in units of 0.01 mm: a map is half as high as wide.
const HEIGHT: i32 = 6_900;

/// The map of a sphere in a frame.
pub(super) struct SphereMap {
    frame: Frame,
    chart: Chart<'static>,
    /// The map, whose coordinates are from 0 to 1.
    pub map: Chart<'static>,
    /// Half of the height of the map, in units of 0.01 mm.
    pub radius: i32,
}

impl SphereMap {
    /// Creates the map in a frame with this caption and this bar of colours.
    ///
    /// # Errors
    /// If the caption cannot be drawn.
    pub fn new(caption: &[String], bar: Option<Scale>) -> Result<Self, Error> {
        let frame = Frame::new(HEIGHT, caption, Scale::default(), bar)?;
        let title =
            "Mollweide's projection; lines every 30° of latitude and 60° of longitude".into();
        let chart = frame.chart(Scale { title, ..Scale::default() })?;
        let field = chart.plotting_area().strip_coord_spec();
        let (width, height) = field.dim_in_pixel();
        let [width, height] = [width as i32, height as i32];
        let radius = (0.985 * f64::from(width.min(2 * height)) / 4.0) as i32;
        let corner = (width / 2 - 2 * radius, height / 2 - radius);
        // A chart ends one unit before the edge of its area.
        let area = field.shrink(corner, (4 * radius + 1, 2 * radius + 1));
        let map = ChartBuilder::on(&area).build_cartesian_2d(Scale::default(), Scale::default())?;
        Ok(Self { frame, chart, map, radius })
    }

    /// Draws the outline, and parallels and meridians every 30 and 60 degrees.
    ///
    /// # Errors
    /// If plotters cannot draw them.
    pub fn draw(&mut self) -> Result<(), Error> {
        let parallels = [-60.0_f64, -30.0, 0.0, 30.0, 60.0].map(|degrees| {
            [-PI, PI].map(|longitude| place([degrees.to_radians(), longitude])).to_vec()
        });
        let meridians = [-120.0_f64, -60.0, 0.0, 60.0, 120.0].map(|degrees| {
            let along = (0..=60).map(|i| PI * (f64::from(i) / 60.0 - 0.5));
            along.map(|latitude| place([latitude, degrees.to_radians()])).collect()
        });
        let style = RGBColor(128, 128, 128).stroke_width(8);
        let lines = parallels.into_iter().chain(meridians);
        self.map.draw_series(lines.map(|line| PathElement::new(line, style)))?;
        let circle = (0..=360).map(|i| (TAU * f64::from(i) / 360.0).sin_cos());
        let outline: Vec<_> = circle.map(|(y, x)| (0.5 + 0.5 * x, 0.5 + 0.5 * y)).collect();
        self.map.draw_series([PathElement::new(outline, rule())])?;
        Ok(())
    }

    /// Draws the caption and the bar of these colours, and returns the drawing.
    ///
    /// # Errors
    /// If a label cannot be drawn.
    pub fn complete(self, colour: impl Fn(f64) -> [u8; 3]) -> Result<String, Error> {
        self.frame.complete(self.chart, colour)
    }
}

/// Returns the place of a latitude and a longitude, in radians, on the map.
pub(super) fn place([latitude, longitude]: [f64; 2]) -> (f64, f64) {
    // Newton's iteration for 2α + sin 2α = π sin(latitude); at the poles, where the derivative vanishes, α is known.
    let mut angle = latitude;
    if latitude.abs() < FRAC_PI_2 - 1e-9 {
        for _ in 0..30 {
            let excess = 2.0 * angle + (2.0 * angle).sin() - PI * latitude.sin();
            angle -= excess / (2.0 + 2.0 * (2.0 * angle).cos());
        }
    }
    (0.5 + 0.5 * longitude / PI * angle.cos(), 0.5 + 0.5 * angle.sin())
}
