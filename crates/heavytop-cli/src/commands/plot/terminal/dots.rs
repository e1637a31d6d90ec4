//! A canvas of dots for a terminal: [`Dots`].

use plotters_backend::{BackendColor, BackendCoord, DrawingBackend, DrawingErrorKind};
use std::convert::Infallible;

/// The dots of a character: two columns, and four rows.
const OF_CHARACTER: [usize; 2] = [2, 4];

/// The bits of a braille character, those of its rows from the top.
const BITS: [[u32; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

/// The character without dots, which the others follow.
const BLANK: u32 = 0x2800;

/// A canvas of dots, on which plotters draws.
pub(super) struct Dots<'a> {
    /// The numbers of characters in a row and in a column.
    size: [usize; 2],
    /// The bits of the characters, row by row.
    characters: &'a mut [u32],
}

impl<'a> Dots<'a> {
    /// Creates a canvas on the bits of characters in rows of this length.
    pub fn new(characters: &'a mut [u32], length: usize) -> Self {
        Self { size: [length, characters.len() / length.max(1)], characters }
    }
}

impl DrawingBackend for Dots<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        let [width, height] = [0, 1].map(|i| (self.size[i] * OF_CHARACTER[i]) as u32);
        (width, height)
    }

    fn ensure_prepared(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn present(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn draw_pixel(
        &mut self,
        (x, y): BackendCoord,
        _color: BackendColor,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y)) else { return Ok(()) };
        let [column, row] = [x / OF_CHARACTER[0], y / OF_CHARACTER[1]];
        if column < self.size[0]
            && let Some(bits) = self.characters.get_mut(row * self.size[0] + column)
        {
            *bits |= BITS[y % OF_CHARACTER[1]][x % OF_CHARACTER[0]];
        }
        Ok(())
    }
}

/// Returns rows of characters with these bits as lines.
pub(super) fn lines(characters: &[u32], length: usize) -> String {
    let row = |row: &[u32]| -> String {
        row.iter().filter_map(|bits| char::from_u32(BLANK + bits)).chain(['\n']).collect()
    };
    characters.chunks(length.max(1)).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_are_where_they_are_drawn() {
        let mut characters = [0; 2 * 2];
        let mut dots = Dots::new(&mut characters, 2);
        assert_eq!(dots.get_size(), (4, 8));
        let black = BackendColor { alpha: 1.0, rgb: (0, 0, 0) };
        for place in [(0, 0), (3, 3), (1, 7), (4, 0), (0, 8), (-1, 2)] {
            assert!(dots.draw_pixel(place, black).is_ok());
        }
        assert_eq!(lines(&characters, 2), "⠁⢀\n⢀⠀\n");
    }
}
