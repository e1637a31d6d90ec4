//! Pictures of the sphere in Mollweide's projection, which conserves areas.
//!
//! With x and y from −1 to 1 and sin α = y, the latitude is asin((2α + sin 2α)/π) and the longitude πx/cos α. Source:
//! J. P. Snyder, *Map Projections: A Working Manual* (1987), p. 251.

use super::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::raster::{bar, image_at, pixels};
use crate::pictures::{Axis, Frame, Scale};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fmt::Write;

/// The numbers of columns and rows of pixels.
const SIZE: [u32; 2] = [960, 480];

/// The end of the scale of colours, in multiples of the root mean square.
const MOST: f64 = 3.0;

/// The height of a picture, in units of 0.01 mm: a map is half as high as wide.
const HEIGHT: f64 = 6_900.0;

/// The place of a map in its frame.
struct Map {
    frame: Frame,
    centre: [f64; 2],
    /// Half of the height.
    radius: f64,
}

impl Map {
    fn new(frame: Frame) -> Self {
        let centre = [(frame.left + frame.right) / 2.0, (frame.top + frame.bottom) / 2.0];
        let radius =
            0.985 * ((frame.right - frame.left) / 4.0).min((frame.bottom - frame.top) / 2.0);
        Self { frame, centre, radius }
    }

    /// Returns the place of a latitude and a longitude, in radians.
    fn place(&self, latitude: f64, longitude: f64) -> [f64; 2] {
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

    /// Draws the outline, and parallels and meridians every 30 and 60 degrees.
    fn draw(&self, svg: &mut String) {
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
}

fn frame_of(run: &RunArrays, what: String, bar: Option<Scale>) -> Frame {
    let blank = Scale { ticks: Vec::new(), title: String::new(), line: None };
    Frame::of_height(HEIGHT, &run.caption(what), blank, bar)
}

/// The words below a map.
fn below() -> Scale {
    let title = "Mollweide's projection; lines every 30° of latitude and 60° of longitude".into();
    Scale { ticks: Vec::new(), title, line: None }
}

/// Draws the vorticity of a fluid at a sample.
///
/// # Errors
/// If the sample cannot be read.
pub(super) fn fluid_picture(run: &mut RunArrays, sample: usize) -> Result<String, Error> {
    let omega = run.sample(sample)?;
    let [columns, rows] = SIZE.map(|count| count as usize);
    let mut cells = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        let angle = (1.0 - 2.0 * (row as f64 + 0.5) / rows as f64).asin();
        let latitude = ((2.0 * angle + (2.0 * angle).sin()) / PI).asin();
        let circle = run.system.on_circle(&omega, FRAC_PI_2 - latitude, 2 * columns);
        let circle = circle.unwrap_or_else(|| vec![f64::NAN; 2 * columns]);
        for column in 0..columns {
            let x = (2.0 * (column as f64 + 0.5) / columns as f64 - 1.0) / angle.cos();
            // The circle begins at the longitude 0, and the map at −180°.
            let index = ((x + 2.0) * columns as f64) as usize % (2 * columns);
            cells.push(circle.get(index).copied().filter(|_| x.abs() < 1.0));
        }
    }
    let inside = cells.iter().flatten();
    // Equal areas of the map are equal areas of the sphere.
    let mean = inside.clone().map(|x| x * x).sum::<f64>() / inside.count().max(1) as f64;
    let most = (MOST * mean.sqrt()).max(f64::MIN_POSITIVE);
    let scale = Scale::linear(&Axis::new(-most, most, 6), "vorticity (1/s)", false);
    let time = run.times.get(sample).copied().unwrap_or_default();
    let size = run.first().1.first().copied().unwrap_or(0);
    let map = Map::new(frame_of(run, format!("N = {size}, t = {time} s"), Some(scale)));
    let mut svg = Frame::begin_of_height(HEIGHT);
    let ([x, y], radius) = (map.centre, map.radius);
    let png = pixels(SIZE, &cells, Some([-most, most]), 255)?;
    image_at(&mut svg, (x - 2.0 * radius, x + 2.0 * radius), (y - radius, y + radius), &png);
    bar(&mut svg, &map.frame, [-most, most])?;
    map.draw(&mut svg);
    map.frame.draw(&mut svg, &below());
    Ok(svg + "</svg>")
}

/// Draws vortices at a sample: disks for positive and rings for negative strengths.
///
/// # Errors
/// If the sample cannot be read.
pub(super) fn vortex_picture(run: &mut RunArrays, sample: usize) -> Result<String, Error> {
    let vortices = run.sample(sample)?;
    let system = run.config.system.as_ref();
    let strengths = system.and_then(|table| table.parameters.get("strengths"));
    let strengths = strengths.map_or(Vec::new(), |numbers| numbers.values().to_vec());
    let time = run.times.get(sample).copied().unwrap_or_default();
    let what = format!("disks positive, rings negative, t = {time} s");
    let map = Map::new(frame_of(run, what, None));
    let mut svg = Frame::begin_of_height(HEIGHT);
    map.draw(&mut svg);
    let radius = (4.0 * map.radius / (vortices.len() as f64).sqrt()).clamp(12.0, 60.0);
    for (vortex, strength) in vortices.as_chunks::<3>().0.iter().zip(&strengths) {
        let [x, y, z] = vortex.map(|component| component / strength);
        let [x, y] = map.place(z.clamp(-1.0, 1.0).asin(), y.atan2(x) % TAU);
        let style = match *strength > 0.0 {
            true => "fill=\"#b2182b\"".to_owned(),
            false => {
                format!("fill=\"none\" stroke=\"#2166ac\" stroke-width=\"{:.0}\"", 0.5 * radius)
            }
        };
        // Writing to a string does not fail.
        let _ = write!(svg, "<circle cx=\"{x:.0}\" cy=\"{y:.0}\" r=\"{radius:.0}\" {style}/>");
    }
    map.frame.draw(&mut svg, &below());
    Ok(svg + "</svg>")
}
