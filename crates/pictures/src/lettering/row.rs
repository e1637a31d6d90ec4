//! Letters side by side.

use super::letters::{Letter, joined};
use crate::fonts::face::Face;
use crate::fonts::faces::glyph;

/// A glyph in a row.
#[derive(Debug)]
pub(super) struct Placed {
    pub(super) face: &'static Face,
    pub(super) glyph: u16,
    /// Where it begins, as a multiple of the size of the letters.
    pub(super) start: f64,
}

/// Returns the glyphs of letters side by side from 0 on, and the width of all, as multiples of their size.
pub(super) fn row(letters: &[Letter]) -> (Vec<Placed>, f64) {
    let letters = joined(letters);
    let (mut row, mut end) = (Vec::with_capacity(letters.len()), 0.0);
    for (n, letter) in letters.iter().enumerate() {
        let Some((face, number)) = glyph(letter.character, letter.is_oblique) else { continue };
        row.push(Placed { face, glyph: number, start: end });
        let next = letters.get(n + 1).and_then(|next| face.glyph(next.character));
        let kerning = next.map_or(0.0, |next| face.kerning(number, next));
        end += (face.advance(number) + kerning) / face.units();
    }
    (row, end)
}
