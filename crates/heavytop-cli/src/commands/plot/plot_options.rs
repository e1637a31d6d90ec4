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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlotOptions {
    /// The number of the sample that is drawn, from 0; the last one without it.
    pub sample: Option<usize>,
    /// The index along the third axis of the plane that is drawn; the middle one without it.
    pub plane: Option<usize>,
    /// The n of which every n-th sample is a frame of a film; without it there are at most 200 frames.
    pub every: Option<usize>,
    /// The frames of a film per second; 20 without it.
    pub fps: Option<u32>,
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
        if let Some((option, _, kind)) = options.into_iter().find(|(_, is_wrong, _)| *is_wrong) {
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
        let options = [
            ("sample", self.sample.is_some() && !view.is_of_a_sample(), samples),
            ("plane", self.plane.is_some() && view != View::Lattice, "lattices of three axes"),
        ];
        match options.into_iter().find(|(_, is_wrong, _)| *is_wrong) {
            Some((option, _, kind)) => Err(Error::OtherPicture { option, kind }),
            None => Ok(()),
        }
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
