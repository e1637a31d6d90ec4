//! A film of a run: a picture of each of several samples.

use super::sample_picture::SamplePicture;
use crate::commands::plot::plot_options::PlotOptions;
use crate::commands::plot::plot_summary::PlotSummary;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::films::film::Film;
use crate::supervision::{Progress, Watch};
use std::path::Path;

/// Draws every n-th sample as a frame. The run is read twice, since all frames have the scales of all samples that are drawn.
///
/// # Errors
/// If the samples cannot be read, or the film cannot be written.
pub(in crate::commands::plot) fn film_of_samples(
    run: &RunArrays,
    mut picture: Box<dyn SamplePicture + '_>,
    out: &Path,
    options: &PlotOptions,
    watch: &Watch<'_>,
) -> Result<PlotSummary, Error> {
    let (parts, samples) = (run.subject.parts(), run.times.len());
    let every = options.stride(samples);
    let frames = samples.div_ceil(every);
    let last = (frames - 1) * every;
    let progress = Progress::of(2 * frames as u64, "frames", watch.quiet);
    let mut done = 0;
    let mut drawn = |number: usize, what: &str| -> Result<bool, Error> {
        watch.require_going()?;
        let is_drawn = number.is_multiple_of(every);
        if is_drawn {
            progress.now(done, what.into());
            done += 1;
        }
        Ok(is_drawn)
    };
    run.each(&parts, |number, sample| {
        if drawn(number, "measuring")? {
            picture.include(sample);
        }
        Ok(number < last)
    })?;
    let mut film = Film::new(out, options.frames_per_second());
    run.each(&parts, |number, sample| {
        if drawn(number, "drawing")? {
            film.add(&picture.draw(sample, run.time(number))?)?;
        }
        Ok(number < last)
    })?;
    film.complete()?;
    Ok(PlotSummary { out: out.into(), time: run.time(last), frames: Some(frames), is_whole: false })
}
