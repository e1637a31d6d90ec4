//! The picture of the track of a direction on the sphere.

use super::sphere_map::{SphereMap, place};
use super::vortex_tracks::{MOST_POINTS, pieces};
use crate::commands::plot::quantities::run_column::RunColumn;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::caption::number;
use crate::pictures::colour_scale::colour;
use crate::pictures::curves::curve::{BLUE, RED};
use plotters::prelude::*;

/// The width of the track, and the radius of the marks at its ends, in units of 0.01 mm.
const TRACK: u32 = 14;
const RADIUS: i32 = 70;

/// A direction that a run has at each sample.
pub(in crate::commands::plot) struct Direction<'a> {
    /// Its name in the caption.
    pub title: String,
    /// The array of the archive that tells it.
    pub array: &'a RunColumn,
    /// Returns a vector along it from a sample of the array.
    pub of: &'a dyn Fn(&[f64]) -> Vec<f64>,
}

/// Draws the track of the direction of a vector over the whole run, with a disk at its start and a ring at its end. Where
/// the vector is 0, it has no direction, and the track a gap.
///
/// # Errors
/// If the samples cannot be read.
pub(in crate::commands::plot) fn direction_track(
    run: &RunArrays,
    Direction { title, array, of }: &Direction<'_>,
) -> Result<String, Error> {
    let (last, stride) = (run.times.len().saturating_sub(1), run.times.len().div_ceil(MOST_POINTS));
    let mut tracks = vec![Vec::new()];
    run.each(&[(array.array.clone(), array.shape.clone())], |sample, values| {
        if sample.is_multiple_of(stride) || sample == last {
            match (direction(&of(values)), tracks.last_mut()) {
                (Some(direction), Some(track)) => track.push(direction),
                _ => tracks.push(Vec::new()),
            }
        }
        Ok(true)
    })?;
    let [start, end] = [0, last].map(|sample| number(run.time(sample)));
    let what = format!("direction of {title}, disk t = {start} s, ring t = {end} s");
    let thinned = (stride > 1).then(|| format!("every {stride} samples one is drawn"));
    let caption: Vec<String> = run.caption(what).into_iter().chain(thinned).collect();
    let mut map = SphereMap::new(&caption, None)?;
    map.draw()?;
    let style = BLUE.stroke_width(TRACK);
    let lines = tracks.iter().flat_map(|track| pieces(track));
    map.map.draw_series(lines.map(|piece| PathElement::new(piece, style)))?;
    let ends = tracks.iter().flatten();
    let ring = |end: &[f64; 2]| Circle::new(place(*end), RADIUS, RED.stroke_width(TRACK * 2));
    map.map.draw_series(ends.clone().next_back().map(ring))?;
    let disk = |start: &[f64; 2]| Circle::new(place(*start), RADIUS * 2 / 3, RED.filled());
    map.map.draw_series(ends.clone().next().map(disk))?;
    map.complete(colour)
}

/// Returns the latitude and the longitude of the direction of a vector, in radians.
fn direction(vector: &[f64]) -> Option<[f64; 2]> {
    let size = vector.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let [x, y, z] = <[f64; 3]>::try_from(vector).ok()?.map(|component| component / size);
    // By the tangent, which is accurate at the poles, and at every size.
    (size > 0.0).then(|| [z.atan2(x.hypot(y)), y.atan2(x)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    #[test]
    fn a_direction_has_no_size() {
        for size in [1e-300, 1.0, 1e300] {
            let found = direction(&[size, size, 0.0]);
            assert!(found.is_some_and(|[latitude, longitude]| {
                latitude == 0.0 && (longitude - FRAC_PI_4).abs() < 1e-15
            }));
            assert!(direction(&[0.0, 0.0, -size]).is_some_and(|place| place[0] == -FRAC_PI_2));
        }
        // Control: neither 0 nor two numbers have one.
        assert_eq!((direction(&[0.0; 3]), direction(&[1.0, 0.0])), (None, None));
    }
}
