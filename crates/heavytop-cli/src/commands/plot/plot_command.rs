//! The command `plot`: reads an archive of a run and draws a picture.

use super::chain_picture::chain_picture;
use super::lattice_picture::lattice_picture;
use super::run_arrays::RunArrays;
use super::sphere_picture::{fluid_picture, vortex_picture};
use crate::errors::Error;
use crate::files::Output;
use crate::files::place::shown;
use crate::pictures::render::{PNG, SVG, render};
use crate::supervision::Watch;
use serde::Serialize;
use std::fmt;
use std::path::{Path, PathBuf};

/// The number of pixels of a PNG for each CSS pixel.
const SCALE: f32 = 3.0;

/// The summary of a picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlotSummary {
    /// The path of the picture.
    pub out: PathBuf,
    /// The time of the sample that is drawn last, s.
    pub time: f64,
}

impl fmt::Display for PlotSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(to, "t = {} s in {}", self.time, shown(&self.out))
    }
}

/// Draws a run in the archive `run`: a chain of spins against time; a plane of a lattice, the vorticity of a fluid, or
/// vortices in Mollweide's projection at a sample, the last one unless its number is given.
///
/// # Errors
/// If the archive cannot be read or is of another run, there is no such sample or plane, or the picture cannot be written.
pub fn plot(
    run: &Path,
    out: &Path,
    (sample, plane): (Option<usize>, Option<usize>),
    watch: &Watch<'_>,
) -> Result<PlotSummary, Error> {
    let is_svg = match out.extension().and_then(|ending| ending.to_str()) {
        Some(ending) if ending.eq_ignore_ascii_case("svg") => true,
        Some(ending) if ending.eq_ignore_ascii_case("png") => false,
        _ => return Err(Error::NoPicture { path: out.into() }),
    };
    watch.safeguard.require(out, if is_svg { &SVG } else { &PNG })?;
    let mut run = RunArrays::open(run)?;
    let last = run.times.len().saturating_sub(1);
    let sample = sample.unwrap_or(last);
    let (name, shape) = run.first();
    if sample > last {
        let range = "that of a sample of the run";
        return Err(Error::OutOfRange { name: "sample", range, value: sample as f64 });
    }
    let drawing = match (name, shape.len()) {
        ("omega", _) => fluid_picture(&mut run, sample)?,
        ("m", _) => vortex_picture(&mut run, sample)?,
        (_, 2) => chain_picture(&mut run)?,
        _ => lattice_picture(&mut run, sample, plane)?,
    };
    let (svg, png) = render(&drawing, SCALE)?;
    Output::whole(out, if is_svg { svg.as_bytes() } else { &png })?;
    let time = run.times.get(sample).copied().unwrap_or_default();
    Ok(PlotSummary { out: out.into(), time })
}
