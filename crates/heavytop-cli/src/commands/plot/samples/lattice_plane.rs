//! The picture of a plane of a lattice of spins: [`LatticePlane`].

use super::sample_picture::SamplePicture;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::caption::number;
use crate::pictures::charts::frame::HEIGHT;
use crate::pictures::charts::scaled_chart::Chart;
use crate::pictures::colour_scale::colour;
use crate::pictures::raster::{cells, range};
use crate::pictures::symbols::symbol;
use crate::pictures::{Axis, Frame, Scale};
use plotters::prelude::*;
use svg_pictures::SvgElement;

/// The largest number of arrows along an axis.
const ARROWS: usize = 32;

/// The spins at one index of the third axis: the third components as colours, the others as arrows.
pub(super) struct LatticePlane<'a> {
    run: &'a RunArrays,
    name: String,
    shape: [usize; 3],
    plane: usize,
    /// The least and the largest third component in the plane.
    ends: [f64; 2],
    /// The length of the longest spin.
    longest: f64,
}

impl<'a> LatticePlane<'a> {
    /// Creates the picture of a plane, the middle one unless it is given.
    ///
    /// # Errors
    /// If there is no such plane.
    pub fn new(run: &'a RunArrays, plane: Option<usize>) -> Result<Self, Error> {
        let (name, shape) = run.subject.state();
        let shape = match shape[..] {
            [nx, ny, _] => [nx, ny, 1],
            [nx, ny, nz, _] => [nx, ny, nz],
            _ => return Err(Error::Figure(format!("{name} has no planes"))),
        };
        let plane = plane.unwrap_or(shape[2] / 2);
        if plane >= shape[2] {
            let range = "below the number of planes";
            return Err(Error::OutOfRange { name: "plane", range, value: plane as f64 });
        }
        let ends = [f64::INFINITY, f64::NEG_INFINITY];
        Ok(Self { run, name, shape, plane, ends, longest: f64::MIN_POSITIVE })
    }

    /// Returns the spin at these indices.
    fn spin(&self, spins: &[[f64; 3]], x: usize, y: usize) -> [f64; 3] {
        let [_, ny, nz] = self.shape;
        spins.get((x * ny + y) * nz + self.plane).copied().unwrap_or_default()
    }

    /// Returns the third components, the rows from the top.
    fn thirds<'b>(&'b self, spins: &'b [[f64; 3]]) -> impl Iterator<Item = f64> + 'b {
        let [nx, ny, _] = self.shape;
        (0..ny).rev().flat_map(move |y| (0..nx).map(move |x| self.spin(spins, x, y)[2]))
    }
}

impl SamplePicture for LatticePlane<'_> {
    fn include(&mut self, sample: &[f64]) {
        let spins = sample.as_chunks::<3>().0;
        let lengths = spins.iter().map(|s| s.iter().map(|x| x * x).sum::<f64>().sqrt());
        self.longest = lengths.fold(self.longest, f64::max);
        let [least, most] = self.ends;
        self.ends = self.thirds(spins).fold([least, most], |[a, b], x| [a.min(x), b.max(x)]);
    }

    fn draw(&self, sample: &[f64], time: f64) -> Result<String, Error> {
        let spins = sample.as_chunks::<3>().0;
        let [nx, ny, nz] = self.shape;
        let thirds: Vec<Option<f64>> = self.thirds(spins).map(Some).collect();
        let range = range(self.ends.into_iter());
        let axis = |count: usize| Axis::new(-0.5, count as f64 - 0.5, 5);
        let ordinate = Scale::linear(&axis(ny), "second index", false);
        let title = format!("{}₃", symbol(&self.name));
        let scale = Scale::linear(&Axis::new(range[0], range[1], 4), &title, false);
        let what = match nz {
            1 => format!("t = {} s", number(time)),
            _ => format!("plane {} of {nz}, t = {} s", self.plane, number(time)),
        };
        let frame = Frame::new(HEIGHT, &self.run.caption(what), ordinate, Some(scale))?;
        let mut chart = frame.chart(Scale::linear(&axis(nx), "first index", false))?;
        let size = [nx as u32, ny as u32];
        chart.draw_series([cells([(0.0, 1.0), (1.0, 0.0)], size, &thirds, range)?])?;
        draw_arrows(&chart, [nx, ny], |x, y| {
            let [first, second, _] = self.spin(spins, x, y);
            [first / self.longest, second / self.longest]
        })?;
        frame.complete(chart, colour)
    }
}

/// Draws an arrow for each spin of the plane, or for some of many.
fn draw_arrows(
    chart: &Chart<'_>,
    [nx, ny]: [usize; 2],
    spin: impl Fn(usize, usize) -> [f64; 2],
) -> Result<(), Error> {
    let field = chart.plotting_area().strip_coord_spec();
    let (width, height) = field.dim_in_pixel();
    let cell = [f64::from(width) / nx as f64, f64::from(height) / ny as f64];
    let strides = [nx, ny].map(|count| count.div_ceil(ARROWS).max(1));
    let length = 0.9 * (cell[0] * strides[0] as f64).min(cell[1] * strides[1] as f64);
    let along = |axis: usize, count| (strides[axis] / 2..count).step_by(strides[axis]);
    let arrow = |(x, y): (usize, usize)| {
        let [first, second] = spin(x, y).map(|part| part * length);
        let centre = [cell[0] * (x as f64 + 0.5), cell[1] * ((ny - y) as f64 - 0.5)];
        let from_centre =
            |[x, y]: [f64; 2]| ((centre[0] + x).round() as i32, (centre[1] - y).round() as i32);
        // The head is two lines at 25° from the shaft.
        let side = |side: f64| {
            let (sin, cos) = (side * 25_f64.to_radians()).sin_cos();
            let [back, up] = [-0.3 * first, -0.3 * second];
            from_centre([0.5 * first + back * cos - up * sin, 0.5 * second + back * sin + up * cos])
        };
        let tip = from_centre([0.5 * first, 0.5 * second]);
        [from_centre([-0.5 * first, -0.5 * second]), tip, side(1.0), tip, side(-1.0)]
    };
    let places = along(0, nx).flat_map(|x| along(1, ny).map(move |y| (x, y)));
    let arrows: Vec<_> = places.map(arrow).collect();
    for style in [WHITE.stroke_width(34), BLACK.stroke_width(14)] {
        field.draw(&SvgElement::lines(arrows.clone(), style))?;
    }
    Ok(())
}
