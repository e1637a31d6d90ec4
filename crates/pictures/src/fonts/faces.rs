//! The faces, and which of them has a character.

use super::face::Face;
use std::sync::LazyLock;

/// DejaVu Sans, upright and oblique.
static FACES: LazyLock<[Option<Face>; 2]> =
    LazyLock::new(|| [dejavu::sans::regular(), dejavu::sans::oblique()].map(Face::new));

/// The glyph of characters that no face has: an empty box.
const MISSING: u16 = 0;

/// Returns the upright or the oblique face; `None` if the crate of the font had a file of another kind.
pub(crate) fn face(is_oblique: bool) -> Option<&'static Face> {
    FACES[usize::from(is_oblique)].as_ref()
}

/// Returns the glyph of a character, of the other face if this one has none.
pub(crate) fn glyph(character: char, is_oblique: bool) -> Option<(&'static Face, u16)> {
    let faces = [face(is_oblique), face(!is_oblique)].into_iter().flatten();
    let found = faces.filter_map(|face| Some((face, face.glyph(character)?))).next();
    found.or_else(|| Some((face(is_oblique)?, MISSING)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::fonts::outline::Segment;

    /// The digits of DejaVu Sans are 1303 of 2048 units wide, its lines 1901 above and 483 below the base.
    #[test]
    fn both_faces_are_read() {
        for face in [false, true].map(|is_oblique| face(is_oblique).unwrap()) {
            assert_eq!(face.units(), 2048.0);
            assert_eq!(face.extent(), [1901.0 / 2048.0, 483.0 / 2048.0]);
            for digit in '0'..='9' {
                assert_eq!(face.advance(face.glyph(digit).unwrap()), 1303.0);
            }
            let pair = |a, b| face.kerning(face.glyph(a).unwrap(), face.glyph(b).unwrap());
            assert!(pair('A', 'V') < 0.0, "kerning");
            assert_eq!(pair('1', '2'), 0.0);
        }
    }

    #[test]
    fn every_glyph_has_an_outline_of_closed_contours() {
        for (is_oblique, glyphs) in [(false, 6253), (true, 5355)] {
            let face = face(is_oblique).unwrap();
            assert_eq!(face.outline(glyphs), None);
            for glyph in 0..glyphs {
                let outline = face.outline(glyph).unwrap();
                let count = |of: fn(&Segment) -> bool| outline.iter().filter(|s| of(s)).count();
                let starts = count(|segment| matches!(segment, Segment::Move(_)));
                let ends = count(|segment| matches!(segment, Segment::Close));
                assert_eq!(starts, ends, "{glyph}");
            }
            assert_eq!(face.outline(face.glyph(' ').unwrap()).unwrap(), []);
        }
    }

    #[test]
    fn a_character_of_one_face_is_found_from_the_other() {
        let only = |has: bool| {
            let lacks = |c: &char| {
                face(true).unwrap().glyph(*c).is_some() == has
                    && face(false).unwrap().glyph(*c).is_some() != has
            };
            ('!'..='\u{ffff}').find(lacks)
        };
        let upright = only(false).unwrap();
        assert!(std::ptr::eq(glyph(upright, true).unwrap().0, face(false).unwrap()));
        // Negative control: a character that both have.
        assert!(std::ptr::eq(glyph('a', true).unwrap().0, face(true).unwrap()));
        let (missing, number) = glyph('\u{10ffff}', true).unwrap();
        assert!(std::ptr::eq(missing, face(true).unwrap()) && number == MISSING);
    }

    #[test]
    fn files_that_are_no_fonts_are_no_faces() {
        let whole = dejavu::sans::regular();
        assert!(Face::new(b"").is_none() && Face::new(b"\0\x01\0\0\0\x10").is_none());
        assert!(Face::new(&whole[..whole.len() / 2]).is_none());
    }
}
