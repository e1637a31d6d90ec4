//! The picture of the vorticity of a fluid on the sphere: [`FluidMap`].
//!
//! The projection is that of [`SphereMap`], whose formula has this inverse, with x and y from −1 to 1 and sin α = y: the latitude
//! asin((2α + sin 2α)/π) and the longitude πx/cos α.

use super::sample_picture::SamplePicture;
use super::sphere_map::SphereMap;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::caption::number;
use crate::pictures::colour_scale::colour;
use crate::pictures::raster::cells;
use crate::pictures::{Axis, Scale};
use lie_poisson_runs::ArraySystem;
use std::f64::consts::{FRAC_PI_2, PI};

/// The numbers of columns and rows of pixels.
const SIZE: [u32; 2] = [960, 480];

/// The largest end of the scale of colours, in multiples of the root mean square: in a turbulent fluid a few vortices are far
/// stronger than the rest.
const MOST: f64 = 3.0;

/// The vorticity of a fluid as colours.
pub(super) struct FluidMap<'a> {
    run: &'a RunArrays,
    system: &'a ArraySystem,
    /// The largest mean square of the vorticity.
    mean_square: f64,
    /// The largest size of the vorticity.
    largest: f64,
    /// The sample that was included last, and its vorticity, which takes long to compute.
    last: (Vec<f64>, Vec<Option<f64>>),
}

impl<'a> FluidMap<'a> {
    pub fn new(run: &'a RunArrays, system: &'a ArraySystem) -> Self {
        Self { run, system, mean_square: 0.0, largest: 0.0, last: Default::default() }
    }

    /// Returns the vorticity in the rows of pixels from the top, and `None` beside the sphere.
    fn vorticity(&self, omega: &[f64]) -> Vec<Option<f64>> {
        let [columns, rows] = SIZE.map(|count| count as usize);
        let mut cells = Vec::with_capacity(columns * rows);
        for row in 0..rows {
            let angle = (1.0 - 2.0 * (row as f64 + 0.5) / rows as f64).asin();
            let latitude = ((2.0 * angle + (2.0 * angle).sin()) / PI).asin();
            let circle = self.system.on_circle(omega, FRAC_PI_2 - latitude, 2 * columns);
            let circle = circle.unwrap_or_else(|| vec![f64::NAN; 2 * columns]);
            for column in 0..columns {
                let x = (2.0 * (column as f64 + 0.5) / columns as f64 - 1.0) / angle.cos();
                // The circle begins at the longitude 0, and the map at −180°.
                let index = ((x + 2.0) * columns as f64) as usize % (2 * columns);
                cells.push(circle.get(index).copied().filter(|_| x.abs() < 1.0));
            }
        }
        cells
    }
}

impl SamplePicture for FluidMap<'_> {
    fn include(&mut self, sample: &[f64]) {
        let cells = self.vorticity(sample);
        let inside = cells.iter().flatten();
        // Equal areas of the map are equal areas of the sphere.
        let count = inside.clone().count().max(1);
        self.mean_square =
            self.mean_square.max(inside.clone().map(|x| x * x).sum::<f64>() / count as f64);
        self.largest = inside.fold(self.largest, |most, x| most.max(x.abs()));
        self.last = (sample.to_vec(), cells);
    }

    fn draw(&self, sample: &[f64], time: f64) -> Result<String, Error> {
        let most = (MOST * self.mean_square.sqrt()).min(self.largest).max(f64::MIN_POSITIVE);
        let title = match most < self.largest {
            true => "vorticity (1/s); what is beyond has the last colour",
            false => "vorticity (1/s)",
        };
        let scale = Scale::linear(&Axis::new(-most, most, 6), title, false);
        let size = self.run.subject.state().1.first().copied().unwrap_or(0);
        let caption = self.run.caption(format!("N = {size}, t = {} s", number(time)));
        let mut map = SphereMap::new(&caption, Some(scale))?;
        let (included, vorticity) = &self.last;
        let computed = (included != sample).then(|| self.vorticity(sample));
        let vorticity = computed.as_ref().unwrap_or(vorticity);
        map.map.draw_series([cells([(0.0, 1.0), (1.0, 0.0)], SIZE, vorticity, [-most, most])?])?;
        map.draw()?;
        map.complete(colour)
    }
}
