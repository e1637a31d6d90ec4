//! The picture of vortices on the sphere: [`VortexMap`].

use super::sample_picture::SamplePicture;
use super::sphere_map::{SphereMap, place};
use super::vortex_tracks::{VortexTracks, places};
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::caption::number;
use crate::pictures::colour_scale::{SIGNS, colour};
use plotters::prelude::*;

/// The width of tracks, in units of 0.01 mm.
const TRACK: u32 = 12;

/// Vortices at a sample, disks for positive and rings for negative strengths, and their tracks over the whole run.
pub(super) struct VortexMap<'a> {
    run: &'a RunArrays,
    strengths: Vec<f64>,
    tracks: VortexTracks,
}

impl<'a> VortexMap<'a> {
    /// Reads the tracks.
    ///
    /// # Errors
    /// If the samples cannot be read.
    pub fn new(run: &'a RunArrays) -> Result<Self, Error> {
        let system = run.config.system.as_ref();
        let strengths = system.and_then(|table| table.parameters.get("strengths"));
        let strengths = strengths.map_or(Vec::new(), |numbers| numbers.values().to_vec());
        let tracks = VortexTracks::read(run, &strengths)?;
        Ok(Self { run, strengths, tracks })
    }
}

impl SamplePicture for VortexMap<'_> {
    fn include(&mut self, _sample: &[f64]) {}

    fn draw(&self, sample: &[f64], time: f64) -> Result<String, Error> {
        let what = format!("disks positive, rings negative, t = {} s", number(time));
        let mut map = SphereMap::new(&self.run.caption(what), None)?;
        map.draw()?;
        for (pieces, strength) in self.tracks.pieces().zip(&self.strengths) {
            let style = sign(*strength).stroke_width(TRACK);
            let lines = pieces.into_iter().map(|piece| PathElement::new(piece, style));
            map.map.draw_series(lines)?;
        }
        let radius = f64::from(4 * map.radius) / (sample.len() as f64).sqrt();
        let radius = radius.clamp(12.0, 60.0) as i32;
        for (vortex, strength) in places(sample, &self.strengths).zip(&self.strengths) {
            let disk = |style| Circle::new(place(vortex), radius, style);
            let colour = sign(*strength);
            match *strength > 0.0 {
                true => map.map.draw_series([disk(colour.filled())])?,
                false => {
                    let ring = colour.stroke_width(radius.unsigned_abs() / 2);
                    map.map.draw_series([disk(WHITE.filled()), disk(ring)])?
                }
            };
        }
        map.complete(colour)
    }
}

/// Returns the colour of a strength.
fn sign(strength: f64) -> RGBColor {
    let [red, green, blue] = SIGNS[usize::from(strength <= 0.0)];
    RGBColor(red, green, blue)
}
