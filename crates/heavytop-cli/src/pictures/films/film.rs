//! Animated GIF: [`Film`].
//!
//! Source: CompuServe, *Graphics Interchange Format, version 89a* (1990).

use super::film_palette::FilmPalette;
use crate::errors::Error;
use crate::files::Output;
use crate::pictures::render::{GIF_COMMENT, pixels};
use gif::{AnyExtension, Encoder, EncodingError, Frame, Repeat};
use std::path::{Path, PathBuf};

/// The label of a comment.
const COMMENT: AnyExtension = AnyExtension(0xfe);

/// The number of pixels for each CSS pixel.
const SCALE: f32 = 2.0;

/// A film that is being written: it runs again and again. Two frames are in memory at a time.
pub(crate) struct Film {
    path: PathBuf,
    delay: u16,
    palette: FilmPalette,
    /// The encoder and the size of the frames, once there is one.
    begun: Option<(Encoder<Output>, [u32; 2])>,
    /// The places of the colours of the last frame.
    last: Vec<u8>,
}

impl Film {
    /// Creates a film with so many frames per second.
    pub fn new(path: &Path, frames_per_second: u32) -> Self {
        // A frame is shown for a whole number of hundredths of a second.
        let delay = (100.0 / f64::from(frames_per_second)).round() as u16;
        Self {
            path: path.into(),
            delay,
            palette: FilmPalette::new(),
            begun: None,
            last: Vec::new(),
        }
    }

    /// Adds a frame, of which the first gives the size of all of them.
    ///
    /// # Errors
    /// If the drawing cannot be drawn or has another size, or the file cannot be written.
    pub fn add(&mut self, drawing: &str) -> Result<(), Error> {
        let (size, pixels) = pixels(drawing, SCALE)?;
        let (width, height) = match size.map(u16::try_from) {
            [Ok(width), Ok(height)] => (width, height),
            _ => return Err(Error::Figure(format!("{size:?} pixels are too many for a film"))),
        };
        if self.begun.is_none() {
            self.begun = Some((self.begin([width, height])?, size));
        }
        let places = self.palette.places(&pixels);
        let transparent = (!self.last.is_empty()).then_some(FilmPalette::CLEAR);
        let buffer = changes(&self.last, &places).into();
        self.last = places;
        let delay = self.delay;
        let frame = Frame { delay, width, height, buffer, transparent, ..Frame::default() };
        match &mut self.begun {
            Some((encoder, own)) if *own == size => {
                encoder.write_frame(&frame).map_err(|error| failed(&self.path, error))
            }
            _ => Err(Error::Figure(format!("a frame of a film has {size:?} pixels"))),
        }
    }

    /// Completes the file and gives it its name; a film without frames is no file.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn complete(self) -> Result<(), Error> {
        let Some((encoder, _)) = self.begun else { return Ok(()) };
        encoder.into_inner().map_err(|error| failed(&self.path, error))?.complete()
    }

    fn begin(&self, [width, height]: [u16; 2]) -> Result<Encoder<Output>, Error> {
        let output = Output::create(&self.path)?;
        let begun = Encoder::new(output, width, height, &self.palette.bytes());
        let begun = begun.and_then(|mut encoder| {
            encoder.write_raw_extension(COMMENT, &[GIF_COMMENT.as_bytes()])?;
            encoder.set_repeat(Repeat::Infinite)?;
            Ok(encoder)
        });
        begun.map_err(|error| failed(&self.path, error))
    }
}

/// Returns the pixels of a frame, without those that are as in the last one: a film of few changes is a short file.
fn changes(last: &[u8], places: &[u8]) -> Vec<u8> {
    match last.len() == places.len() {
        true => {
            let pairs = last.iter().zip(places);
            pairs.map(|(old, new)| if old == new { FilmPalette::CLEAR } else { *new }).collect()
        }
        false => places.to_vec(),
    }
}

fn failed(path: &Path, error: EncodingError) -> Error {
    match error {
        EncodingError::Io(source) => Error::Write { path: path.into(), source },
        error => Error::Figure(error.to_string()),
    }
}
