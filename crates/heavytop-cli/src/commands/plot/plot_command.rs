//! The command `plot`: reads an archive of a run and draws a picture or a film.

use super::histories::chain_picture::chain_picture;
use super::histories::panels_picture::panels_picture;
use super::picture_format::PictureFormat;
use super::plot_options::PlotOptions;
use super::plot_summary::PlotSummary;
use super::run_arrays::RunArrays;
use super::samples::choice::sample_picture;
use super::samples::film_of_samples::film_of_samples;
use super::samples::sample_picture::SamplePicture;
use super::view::View;
use crate::errors::Error;
use crate::files::Output;
use crate::pictures::render::render;
use crate::supervision::Watch;
use std::path::Path;

/// The number of pixels of a PNG for each CSS pixel.
const SCALE: f32 = 3.0;

/// Draws a run in the archive `run`: a plane of a lattice, the vorticity of a fluid, or vortices in Mollweide's projection at a
/// sample, or as a film; a chain of spins, or the coordinates of another system or of a top, against time.
///
/// # Errors
/// If the archive cannot be read, there is no such sample, plane or film, or the picture cannot be written.
pub fn plot(
    run: &Path,
    out: &Path,
    options: PlotOptions,
    watch: &Watch<'_>,
) -> Result<PlotSummary, Error> {
    let format = PictureFormat::of(out)?;
    options.require(format)?;
    watch.safeguard.require(out, &format.kind())?;
    let run = RunArrays::open(run)?;
    let last = run.times.len().saturating_sub(1);
    let sample = options.sample.unwrap_or(last);
    if sample > last {
        let range = "that of a sample of the run";
        return Err(Error::OutOfRange { name: "sample", range, value: sample as f64 });
    }
    options.require_of(run.subject.view())?;
    let drawing = match sample_picture(&run, options.plane)? {
        Some(picture) if format == PictureFormat::Gif => {
            return film_of_samples(&run, picture, out, options, watch);
        }
        None if format == PictureFormat::Gif => {
            return Err(Error::NoFilm { path: out.into() });
        }
        Some(picture) => drawing_of(&run, picture, sample)?,
        None if run.subject.view() == View::Chain => chain_picture(&run)?,
        None => panels_picture(&run)?,
    };
    let (svg, png) = render(&drawing, SCALE)?;
    Output::whole(out, if format == PictureFormat::Svg { svg.as_bytes() } else { &png })?;
    let is_whole = !run.subject.view().is_of_a_sample();
    Ok(PlotSummary { out: out.into(), time: run.time(sample), frames: None, is_whole })
}

/// Draws a sample.
fn drawing_of(
    run: &RunArrays,
    mut picture: Box<dyn SamplePicture + '_>,
    sample: usize,
) -> Result<String, Error> {
    let mut drawing = String::new();
    run.each(&run.subject.parts(), |number, numbers| {
        if number == sample {
            picture.include(numbers);
            drawing = picture.draw(numbers, run.time(number))?;
        }
        Ok(number < sample)
    })?;
    Ok(drawing)
}
