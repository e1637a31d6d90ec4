//! The arguments of an example: numbers and files in a fixed order, and a picture.

use std::error::Error;
use std::path::PathBuf;
use std::str::FromStr;

/// The arguments of an example.
pub struct Arguments {
    /// What to write the picture to: the argument that ends in `.png` or `.svg`, if there is one.
    pub picture: Option<PathBuf>,
    others: Vec<String>,
}

impl Arguments {
    /// Reads the arguments of the program.
    ///
    /// # Errors
    /// Returns a message if there are more than `most` beside the picture.
    pub fn read(most: usize) -> Result<Self, Box<dyn Error>> {
        let is_picture =
            |argument: &String| argument.ends_with(".png") || argument.ends_with(".svg");
        let (mut pictures, others): (Vec<_>, Vec<_>) =
            std::env::args().skip(1).partition(is_picture);
        if others.len() > most || pictures.len() > 1 {
            return Err(format!("at most {most} arguments and one picture are possible").into());
        }
        Ok(Self { picture: pictures.pop().map(PathBuf::from), others })
    }

    /// Returns the argument at a place as text, if it is given.
    pub fn text(&self, place: usize) -> Option<&str> {
        self.others.get(place).map(String::as_str)
    }

    /// Returns the number at a place, or `default` if it is not given.
    ///
    /// # Errors
    /// Returns a message with the name and the text if the text is not such a number.
    pub fn number<N: FromStr>(
        &self,
        place: usize,
        name: &str,
        default: N,
    ) -> Result<N, Box<dyn Error>> {
        let Some(text) = self.text(place) else { return Ok(default) };
        text.parse().map_err(|_| format!("{name}: '{text}' is not a number of this kind").into())
    }
}
