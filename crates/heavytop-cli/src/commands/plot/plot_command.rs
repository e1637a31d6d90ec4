//! The command `plot`: reads an archive of a run and draws a picture.

use super::histories::chain_picture::chain_picture;
use super::histories::panels_picture::panels_picture;
use super::plot_options::PlotOptions;
use super::plot_summary::PlotSummary;
use super::run_arrays::RunArrays;
use super::run_subject::View;
use super::samples::choice::sample_picture;
use crate::errors::Error;
use crate::files::Output;
use crate::pictures::render::{PNG, SVG, render};
use crate::supervision::Watch;
use std::path::Path;

/// The number of pixels of a PNG for each CSS pixel.
const SCALE: f32 = 3.0;

/// Draws a run in the archive `run`: a plane of a lattice, the vorticity of a fluid, or vortices in Mollweide's projection at a
/// sample; a chain of spins, or the coordinates of another system or of a top, against time.
///
/// # Errors
/// If the archive cannot be read, there is no such sample or plane, or the picture cannot be written.
pub fn plot(
    run: &Path,
    out: &Path,
    options: PlotOptions,
    watch: &Watch<'_>,
) -> Result<PlotSummary, Error> {
    let is_svg = match out.extension().and_then(|ending| ending.to_str()) {
        Some(ending) if ending.eq_ignore_ascii_case("svg") => true,
        Some(ending) if ending.eq_ignore_ascii_case("png") => false,
        _ => return Err(Error::NoPicture { path: out.into() }),
    };
    watch.safeguard.require(out, if is_svg { &SVG } else { &PNG })?;
    let run = RunArrays::open(run)?;
    let last = run.times.len().saturating_sub(1);
    let sample = options.sample.unwrap_or(last);
    if sample > last {
        let range = "that of a sample of the run";
        return Err(Error::OutOfRange { name: "sample", range, value: sample as f64 });
    }
    let drawing = match sample_picture(&run, options.plane)? {
        Some(mut picture) => {
            let mut drawing = String::new();
            run.each(&run.subject.parts(), |number, numbers| {
                if number == sample {
                    picture.include(numbers);
                    drawing = picture.draw(numbers, run.time(number))?;
                }
                Ok(number < sample)
            })?;
            drawing
        }
        None if run.subject.view() == View::Chain => chain_picture(&run)?,
        None => panels_picture(&run)?,
    };
    let (svg, png) = render(&drawing, SCALE)?;
    Output::whole(out, if is_svg { svg.as_bytes() } else { &png })?;
    Ok(PlotSummary { out: out.into(), time: run.time(sample), frames: None })
}
