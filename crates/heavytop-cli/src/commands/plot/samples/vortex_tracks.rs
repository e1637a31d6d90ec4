//! The tracks of vortices on the sphere: [`VortexTracks`].

use super::sphere_map::place;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use std::f64::consts::{PI, TAU};

/// The largest number of vortices whose tracks are drawn: those of more would hide each other.
const MOST_VORTICES: usize = 48;

/// The largest number of points of a track.
pub(super) const MOST_POINTS: usize = 4000;

/// The latitudes and longitudes that vortices pass through, in radians.
#[derive(Clone, Debug)]
pub(super) struct VortexTracks {
    /// The points of each vortex.
    tracks: Vec<Vec<[f64; 2]>>,
}

impl VortexTracks {
    /// Reads the tracks over a whole run; there are none of more than 48 vortices.
    ///
    /// # Errors
    /// If the samples cannot be read.
    pub fn read(run: &RunArrays, strengths: &[f64]) -> Result<Self, Error> {
        let mut tracks = vec![Vec::new(); strengths.len()];
        if strengths.len() <= MOST_VORTICES {
            let (last, stride) = (run.times.len() - 1, run.times.len().div_ceil(MOST_POINTS));
            run.each(&run.subject.parts(), |number, sample| {
                if number.is_multiple_of(stride) || number == last {
                    for (track, place) in tracks.iter_mut().zip(places(sample, strengths)) {
                        track.push(place);
                    }
                }
                Ok(true)
            })?;
        }
        Ok(Self { tracks })
    }

    /// Returns the tracks on the map: of each vortex its pieces, which end where it leaves the map.
    pub fn pieces(&self) -> impl Iterator<Item = Vec<Vec<(f64, f64)>>> {
        self.tracks.iter().map(|track| pieces(track))
    }
}

/// Returns the pieces on the map of a track through these latitudes and longitudes.
pub(super) fn pieces(track: &[[f64; 2]]) -> Vec<Vec<(f64, f64)>> {
    let mut pieces = vec![Vec::new()];
    let mut last = None;
    for point in track {
        let edges = last.and_then(|last| edges(last, *point));
        if let (Some([end, begin]), Some(piece)) = (edges, pieces.last_mut()) {
            piece.push(place(end));
            pieces.push(vec![place(begin)]);
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push(place(*point));
        }
        last = Some(*point);
    }
    pieces
}

/// Returns the latitude and the longitude of each vortex of a sample.
pub(super) fn places(sample: &[f64], strengths: &[f64]) -> impl Iterator<Item = [f64; 2]> {
    sample.as_chunks::<3>().0.iter().zip(strengths).map(|(vortex, strength)| {
        let [x, y, z] = vortex.map(|component| component / strength);
        [z.clamp(-1.0, 1.0).asin(), y.atan2(x)]
    })
}

/// Returns the places on both edges of the map where a track leaves it and enters it again, if it does.
fn edges([latitude, longitude]: [f64; 2], [next, end]: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    if (end - longitude).abs() <= PI {
        return None;
    }
    let edge = PI.copysign(longitude);
    let part = (edge - longitude) / (end + TAU.copysign(longitude) - longitude);
    let crossing = latitude + (next - latitude) * part;
    Some([[crossing, edge], [crossing, -edge]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_track_that_leaves_the_map_comes_back_on_its_other_edge() {
        assert_eq!(edges([0.1, 3.0], [0.2, 2.9]), None);
        let found = edges([0.1, 3.0], [0.3, -3.0]);
        assert!(found.is_some_and(|[[one, left], [other, right]]| {
            (one - 0.2).abs() < 1e-12 && one == other && left == PI && right == -PI
        }));
        let back = edges([0.3, -3.0], [0.1, 3.0]);
        assert!(back.is_some_and(|[[one, left], _]| (one - 0.2).abs() < 1e-12 && left == -PI));
    }
}
