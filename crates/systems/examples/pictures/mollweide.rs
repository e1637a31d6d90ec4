//! The map of the sphere in Mollweide's projection, which conserves areas.
//!
//! With x and y from −1 to 1, sin α = y, the latitude is asin((2α + sin 2α)/π) and the longitude πx/cos α.

use super::canvas::{Area, PIXEL, TEXT, text};
use super::colours::GREY;
use nalgebra::Vector3;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

/// Returns x and y of a latitude and a longitude in radians, both from −1 to 1.
pub fn project(latitude: f64, longitude: f64) -> [f64; 2] {
    // Newton's iteration for 2α + sin 2α = π sin(latitude); at the poles, where the derivative vanishes, α is known.
    let mut angle = latitude;
    if latitude.abs() < FRAC_PI_2 - 1e-9 {
        for _ in 0..30 {
            let excess = 2.0 * angle + (2.0 * angle).sin() - PI * latitude.sin();
            angle -= excess / (2.0 + 2.0 * (2.0 * angle).cos());
        }
    }
    [longitude / PI * angle.cos(), angle.sin()]
}

/// Returns the latitude of the parallel at y, from −1 to 1, and the half width of the map there.
pub fn parallel(y: f64) -> (f64, f64) {
    let angle = y.asin();
    (((2.0 * angle + (2.0 * angle).sin()) / PI).asin(), angle.cos())
}

/// A map in an area: its centre, and half of its height.
pub struct Map {
    centre: (i32, i32),
    radius: f64,
}

impl Map {
    /// Creates the largest map in an area, with room for the labels of the latitudes on the left and a title above.
    pub fn new(area: &Area) -> Self {
        let (width, height) = area.dim_in_pixel();
        let (left, top, room) = (46 * PIXEL, 36 * PIXEL, 12 * PIXEL);
        let radius = ((width as i32 - left - room) / 4).min((height as i32 - top - room) / 2);
        let centre = ((left + width as i32 - room) / 2, top + radius);
        Self { centre, radius: f64::from(radius) }
    }

    /// Returns left, top, right and bottom of the map in its area.
    pub fn corners(&self) -> [i32; 4] {
        let (radius, (x, y)) = (self.radius as i32, self.centre);
        [x - 2 * radius, y - radius, x + 2 * radius, y + radius]
    }

    /// Returns the place of a latitude and a longitude in radians.
    pub fn place(&self, latitude: f64, longitude: f64) -> (i32, i32) {
        let [x, y] = project(latitude, longitude);
        let along = |centre: i32, part: f64| centre + (self.radius * part).round() as i32;
        (along(self.centre.0, 2.0 * x), along(self.centre.1, -y))
    }

    /// Draws the title, the outline, and parallels and meridians each 30 and 60 degrees with their labels.
    ///
    /// # Errors
    /// Returns the reason of the library for drawing.
    pub fn draw(&self, area: &Area, title: &str) -> Result<(), Box<dyn Error>> {
        let style = text(TEXT, &BLACK, (HPos::Center, VPos::Center));
        area.draw(&Text::new(title, (self.centre.0, 16 * PIXEL), style))?;
        let along =
            |from: f64, to: f64| (0..=60).map(move |i| from + (to - from) * f64::from(i) / 60.0);
        let grey = GREY.stroke_width(PIXEL as u32 / 2);
        for degrees in [-60_i32, -30, 0, 30, 60] {
            let latitude = f64::from(degrees).to_radians();
            let line: Vec<_> =
                along(-PI, PI).map(|longitude| self.place(latitude, longitude)).collect();
            let (x, y) = line[0];
            area.draw(&PathElement::new(line, grey))?;
            let label = format!("{degrees}°").replace('-', "−");
            let style = text(TEXT * 0.8, &BLACK, (HPos::Right, VPos::Center));
            area.draw(&Text::new(label, (x - 8 * PIXEL, y), style))?;
        }
        for degrees in [-180_i32, -120, -60, 0, 60, 120, 180] {
            let longitude = f64::from(degrees).to_radians();
            let line: Vec<_> = along(-FRAC_PI_2, FRAC_PI_2)
                .map(|latitude| self.place(latitude, longitude))
                .collect();
            let edge = degrees.abs() == 180;
            let style = if edge { BLACK.stroke_width(PIXEL as u32) } else { grey };
            area.draw(&PathElement::new(line, style))?;
            if !edge && degrees != 0 {
                let (x, y) = self.place(0.0, longitude);
                let ground = [(x + 2 * PIXEL, y + 2 * PIXEL), (x + 38 * PIXEL, y + 16 * PIXEL)];
                area.draw(&Rectangle::new(ground, WHITE.mix(0.6).filled()))?;
                let style = text(TEXT * 0.7, &BLACK, (HPos::Left, VPos::Top));
                let label = format!("{degrees}°").replace('-', "−");
                area.draw(&Text::new(label, (x + 3 * PIXEL, y + 3 * PIXEL), style))?;
            }
        }
        Ok(())
    }

    /// Draws the path of a point of the unit sphere, in pieces where it leaves the map at one side.
    ///
    /// # Errors
    /// Returns the reason of the library for drawing.
    pub fn path(
        &self,
        area: &Area,
        points: impl Iterator<Item = Vector3<f64>>,
        style: ShapeStyle,
    ) -> Result<(), Box<dyn Error>> {
        let mut piece: Vec<(i32, i32)> = Vec::new();
        for x in points {
            let place = self.place(x.z.clamp(-1.0, 1.0).asin(), x.y.atan2(x.x));
            let jumps =
                piece.last().is_some_and(|last| f64::from((place.0 - last.0).abs()) > self.radius);
            if jumps {
                area.draw(&PathElement::new(std::mem::take(&mut piece), style))?;
            }
            piece.push(place);
        }
        area.draw(&PathElement::new(piece, style))?;
        Ok(())
    }

    /// Draws a point of the unit sphere as a disk of a radius in pixels, or as a ring.
    ///
    /// # Errors
    /// Returns the reason of the library for drawing.
    pub fn dot(
        &self,
        area: &Area,
        x: &Vector3<f64>,
        radius: i32,
        colour: RGBColor,
        full: bool,
    ) -> Result<(), Box<dyn Error>> {
        let place = self.place(x.z.clamp(-1.0, 1.0).asin(), x.y.atan2(x.x));
        let style = if full { colour.filled() } else { colour.stroke_width(2 * PIXEL as u32) };
        area.draw(&Circle::new(place, radius * PIXEL, style))?;
        Ok(())
    }
}
