//! What is drawn of a run, and how: [`PlotOptions`].

use super::picture_format::PictureFormat;
use super::view::View;
use crate::errors::Error;

/// The most frames of a film per second: viewers slow faster ones down.
const MOST_FRAMES_PER_SECOND: u32 = 50;

/// The frames of a film per second, unless they are chosen.
const FRAMES_PER_SECOND: u32 = 20;

/// The largest number of frames, unless the samples are chosen.
const MOST_FRAMES: usize = 200;

/// The options of `plot`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlotOptions {
    /// The number of the sample that is drawn, from 0; the last one without it.
    pub sample: Option<usize>,
    /// The index along the third axis of the plane that is drawn; the middle one without it.
    pub plane: Option<usize>,
    /// The n of which every n-th sample is a frame of a film; without it there are at most 200 frames.
    pub every: Option<usize>,
    /// The frames of a film per second; 20 without it.
    pub fps: Option<u32>,
    /// The names of the columns or arrays that are drawn, in their order; without any the picture shows the state.
    pub columns: Vec<String>,
    /// The name of the column against which they are drawn; the time without it.
    pub against: Option<String>,
    /// The name of the array of a vector of three components whose direction is drawn on the sphere.
    pub trace: Option<String>,
}

impl PlotOptions {
    /// Checks that a picture of a format has the options that are given.
    ///
    /// # Errors
    /// [`Error::OtherPicture`] or [`Error::OutOfRange`].
    pub(super) fn require(&self, format: PictureFormat) -> Result<(), Error> {
        let is_film = format == PictureFormat::Gif;
        let films = "films, whose names end in .gif";
        let stills = "pictures of one time, whose names end in .png or .svg";
        let options = [
            ("sample", self.sample.is_some() && is_film, stills),
            ("every", self.every.is_some() && !is_film, films),
            ("fps", self.fps.is_some() && !is_film, films),
        ];
        let has_columns = !self.columns.is_empty();
        let without_trace = "pictures without --trace";
        let mut options = options.into_iter().chain([
            ("columns", has_columns && self.trace.is_some(), without_trace),
            ("against", self.against.is_some() && self.trace.is_some(), without_trace),
            ("against", self.against.is_some() && !has_columns, "pictures of --columns"),
        ]);
        if let Some((option, _, kind)) = options.find(|(_, is_wrong, _)| *is_wrong) {
            return Err(Error::OtherPicture { option, kind });
        }
        if self.every == Some(0) {
            return Err(Error::OutOfRange { name: "every", range: "at least 1", value: 0.0 });
        }
        match self.fps.filter(|fps| !(1..=MOST_FRAMES_PER_SECOND).contains(fps)) {
            Some(fps) => {
                Err(Error::OutOfRange { name: "fps", range: "from 1 to 50", value: fps.into() })
            }
            None => Ok(()),
        }
    }

    /// Checks that the picture of a run has the options that are given.
    ///
    /// # Errors
    /// [`Error::OtherPicture`].
    pub(super) fn require_of(&self, view: View) -> Result<(), Error> {
        let samples = "lattices, fluids and vortices: this picture shows the whole run";
        let has_plane = view == View::Lattice && !self.is_whole(view);
        let options = [
            ("sample", self.sample.is_some() && self.is_whole(view), samples),
            ("plane", self.plane.is_some() && !has_plane, "lattices of three axes"),
        ];
        match options.into_iter().find(|(_, is_wrong, _)| *is_wrong) {
            Some((option, _, kind)) => Err(Error::OtherPicture { option, kind }),
            None => Ok(()),
        }
    }

    /// Returns the option that chooses columns or a direction, if one does.
    pub(super) fn of_columns(&self) -> Option<&'static str> {
        let trace = self.trace.is_some().then_some("trace");
        trace.or((!self.columns.is_empty()).then_some("columns"))
    }

    /// Returns whether the picture of a run shows the whole run, and not a sample.
    pub(super) fn is_whole(&self, view: View) -> bool {
        self.of_columns().is_some() || !view.is_of_a_sample()
    }

    /// Returns the n of which every n-th of so many samples is a frame of a film.
    pub(super) fn stride(&self, samples: usize) -> usize {
        self.every.unwrap_or(samples.div_ceil(MOST_FRAMES)).max(1)
    }

    /// Returns the frames of a film per second.
    pub(super) fn frames_per_second(&self) -> u32 {
        self.fps.unwrap_or(FRAMES_PER_SECOND)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_film_has_at_most_200_frames_unless_samples_are_chosen() {
        let (free, chosen) =
            (PlotOptions::default(), PlotOptions { every: Some(3), ..PlotOptions::default() });
        for samples in [1_usize, 2, 199, 200, 201, 400, 401, 12_345] {
            let frames = samples.div_ceil(free.stride(samples));
            assert!(frames <= 200 && frames >= samples.min(100), "{samples} {frames}");
            assert_eq!(chosen.stride(samples), 3);
        }
        assert_eq!(free.frames_per_second(), 20);
    }
}
