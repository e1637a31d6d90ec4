//! The picture of vortices on the sphere: [`VortexMap`].

use super::sample_picture::SamplePicture;
use super::sphere_map::SphereMap;
use super::vortex_tracks::{VortexTracks, places};
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::caption::number;
use crate::pictures::colour_scale::SIGNS;
use std::fmt::Write;

/// The width of tracks, in units of 0.01 mm.
const TRACK: f64 = 12.0;

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
        let map = SphereMap::new(&self.run.caption(what), None);
        let mut svg = SphereMap::begin();
        map.draw(&mut svg);
        for (path, strength) in self.tracks.paths(&map).zip(&self.strengths) {
            let colour = colour(*strength);
            // Writing to a string does not fail.
            let _ = write!(
                svg,
                "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{TRACK}\" \
                 stroke-linejoin=\"round\"/>"
            );
        }
        let radius = (4.0 * map.radius / (sample.len() as f64).sqrt()).clamp(12.0, 60.0);
        for ([latitude, longitude], strength) in
            places(sample, &self.strengths).zip(&self.strengths)
        {
            let [x, y] = map.place(latitude, longitude);
            let colour = colour(*strength);
            let style = match *strength > 0.0 {
                true => format!("fill=\"{colour}\""),
                false => {
                    format!(
                        "fill=\"white\" stroke=\"{colour}\" stroke-width=\"{:.0}\"",
                        0.5 * radius
                    )
                }
            };
            let _ = write!(svg, "<circle cx=\"{x:.0}\" cy=\"{y:.0}\" r=\"{radius:.0}\" {style}/>");
        }
        Ok(map.complete(svg))
    }
}

/// Returns the colour of a strength, as CSS writes it.
fn colour(strength: f64) -> String {
    let [red, green, blue] = SIGNS[usize::from(strength <= 0.0)];
    format!("rgb({red},{green},{blue})")
}
