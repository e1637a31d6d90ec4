//! The texts of a drawing.

use super::attributes::{anchor, check, length, size};
use super::letters::{Letter, SVG, letters};
use crate::error::PictureError;
use roxmltree::{Document, Node};

/// The largest absolute value of coordinates of letters, which renderers compute with in single precision.
pub(super) const MOST: f64 = 1e9;

/// A text, and where it is in the coordinates of its element.
#[derive(Debug)]
pub(super) struct Text {
    pub(super) letters: Vec<Letter>,
    /// The size of the letters.
    pub(super) size: f64,
    /// The place of the anchor, on the base of the line.
    pub(super) place: [f64; 2],
    /// The part of the text that is left of its place.
    pub(super) anchor: f64,
}

impl Text {
    pub(super) fn new(node: Node<'_, '_>) -> Result<Self, PictureError> {
        check(node)?;
        let size = size(node)?;
        let along = |name| length(node, name, size);
        let place = [along("x")? + along("dx")?, along("y")? + along("dy")?];
        Ok(Self { letters: letters(node)?, size, place, anchor: anchor(node)? })
    }

    /// Returns whether nothing is drawn.
    pub(super) fn is_empty(&self) -> bool {
        self.letters.is_empty() || self.size == 0.0
    }

    /// Returns the characters.
    pub(super) fn content(&self) -> String {
        self.letters.iter().map(|letter| letter.character).collect()
    }
}

/// Reads a drawing.
pub(super) fn read(drawing: &str) -> Result<Document<'_>, PictureError> {
    Document::parse(drawing).map_err(|error| PictureError::Xml { reason: error.to_string() })
}

/// Returns the elements `text` of a drawing.
pub(super) fn texts<'a, 'input>(
    document: &'a Document<'input>,
) -> impl Iterator<Item = Node<'a, 'input>> {
    document.descendants().filter(|node| node.has_tag_name((SVG, "text")))
}

/// Returns a coordinate if drawings reach so far.
pub(super) fn within(coordinate: f64) -> Result<f64, PictureError> {
    match coordinate.abs() <= MOST {
        true => Ok(coordinate),
        false => Err(PictureError::Far { coordinate, most: MOST }),
    }
}
