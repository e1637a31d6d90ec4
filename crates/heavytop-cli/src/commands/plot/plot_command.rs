//! The command `plot`: reads an archive of a run and draws a picture or a film.

use super::picture_format::PictureFormat;
use super::plot_options::PlotOptions;
use super::plot_summary::PlotSummary;
use super::run_arrays::RunArrays;
use super::samples::choice::sample_picture;
use super::samples::film_of_samples::film_of_samples;
use super::samples::sample_picture::SamplePicture;
use super::whole_run::whole_run;
use super::whole_text::whole_text;
use crate::errors::Error;
use crate::files::Output;
use crate::pictures::render::render;
use crate::supervision::Watch;
use std::path::Path;

/// The number of pixels of a PNG for each CSS pixel.
const SCALE: f32 = 3.0;

/// Draws a run in the archive `run`: a plane of a lattice, the vorticity of a fluid, or vortices in Mollweide's projection at a
/// sample, or as a film; a chain of spins, or the coordinates of another system or of a top, against time. The options may
/// choose columns, what they are drawn against, or the track of a direction.
///
/// # Errors
/// If the archive cannot be read, there is no such sample, plane, film or column, or the picture cannot be written.
pub fn plot(
    run: &Path,
    out: &Path,
    options: &PlotOptions,
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
    let (is_whole, is_film) = (options.is_whole(run.subject.view()), format == PictureFormat::Gif);
    let picture = if is_whole { None } else { sample_picture(&run, options.plane)? };
    let drawing = match picture {
        Some(picture) if is_film => return film_of_samples(&run, picture, out, options, watch),
        None if is_film => return Err(Error::NoFilm { path: out.into() }),
        Some(picture) => drawing_of(&run, picture, sample)?,
        None => whole_run(&run, options)?,
    };
    let (svg, png) = render(&drawing, SCALE)?;
    Output::whole(out, if format == PictureFormat::Svg { svg.as_bytes() } else { &png })?;
    Ok(PlotSummary { out: out.into(), time: run.time(sample), frames: None, is_whole })
}

/// Draws a run in the archive `run` as text, for a terminal: a chart for each column that the options choose, or for each of the
/// first coordinates.
///
/// # Errors
/// If the archive cannot be read, there is no such column, or what is asked for needs a picture.
pub fn plot_as_text(run: &Path, options: &PlotOptions) -> Result<String, Error> {
    options.require(PictureFormat::Svg)?;
    let run = RunArrays::open(run)?;
    options.require_of(run.subject.view())?;
    whole_text(&run, options)
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
