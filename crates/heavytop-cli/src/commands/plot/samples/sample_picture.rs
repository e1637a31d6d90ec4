//! A picture that shows one sample of a run: [`SamplePicture`].

use crate::errors::Error;

/// A picture that shows one sample of a run. A film has such a picture of each of several samples.
pub(in crate::commands::plot) trait SamplePicture {
    /// Extends the scales to a sample. They are those of all pictures of a film.
    fn include(&mut self, sample: &[f64]);

    /// Draws a sample that is included.
    ///
    /// # Errors
    /// If the picture would have too many pixels.
    fn draw(&self, sample: &[f64], time: f64) -> Result<String, Error>;
}
