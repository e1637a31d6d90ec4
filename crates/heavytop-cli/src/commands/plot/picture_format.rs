//! The format of a picture, by the ending of its name: [`PictureFormat`].

use crate::errors::Error;
use crate::files::Kind;
use crate::pictures::render::{GIF, PNG, SVG};
use std::path::Path;

/// The format of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PictureFormat {
    Png,
    Svg,
    /// A film.
    Gif,
}

impl PictureFormat {
    /// Returns the format of a file.
    ///
    /// # Errors
    /// [`Error::NoPicture`] if its name has another ending.
    pub fn of(path: &Path) -> Result<Self, Error> {
        let ending = path.extension().and_then(|ending| ending.to_str());
        match ending.map(str::to_ascii_lowercase).as_deref() {
            Some("png") => Ok(Self::Png),
            Some("svg") => Ok(Self::Svg),
            Some("gif") => Ok(Self::Gif),
            _ => Err(Error::NoPicture { path: path.into() }),
        }
    }

    /// Returns how files of this format are recognised.
    pub fn kind(self) -> Kind<'static> {
        match self {
            Self::Png => PNG,
            Self::Svg => SVG,
            Self::Gif => GIF,
        }
    }
}
