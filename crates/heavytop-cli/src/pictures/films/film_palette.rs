//! The colours of a film: [`FilmPalette`].

use crate::pictures::colour_scale::{SIGNS, colour};
use std::collections::HashMap;

/// The number of colours of the scale.
const SHADES: usize = 128;

/// The numbers of grays, of colours of the scale that are blended with white, black and gray, and of blends of the marks.
const BLENDS: [usize; 3] = [17, 16, 7];

/// The colours of all frames of a film: those of the scale, of the marks and of the lines, and blends at their edges.
///
/// A value has the same colour in all frames, so that no colours are chosen for each frame by itself.
#[derive(Clone, Debug)]
pub(super) struct FilmPalette {
    colours: Vec<[u8; 3]>,
    /// The places of the nearest colours of those that have been looked up.
    nearest: HashMap<[u8; 3], u8>,
}

impl FilmPalette {
    /// The place of no colour, for pixels that stay as they are.
    pub const CLEAR: u8 = 255;

    pub fn new() -> Self {
        const WHITE: [u8; 3] = [255; 3];
        const BLACK: [u8; 3] = [0; 3];
        /// The gray of parallels and meridians.
        const LINES: [u8; 3] = [128; 3];
        let shade = |index: usize, count: usize| colour(index as f64 / (count - 1) as f64);
        let [grays, blended, marks] = BLENDS;
        let mut colours: Vec<_> = (0..SHADES).map(|index| shade(index, SHADES)).collect();
        colours.extend((0..grays).map(|index| blend(BLACK, WHITE, index, grays - 1)));
        for index in 0..blended {
            let edge = |other, part| blend(shade(index, blended), other, part, 6);
            let edges = [(WHITE, 2), (WHITE, 4), (BLACK, 2), (BLACK, 4), (LINES, 3)];
            colours.extend(edges.map(|(other, part)| edge(other, part)));
        }
        for sign in SIGNS {
            colours.extend((0..marks).map(|part| blend(sign, WHITE, part, marks)));
        }
        Self { colours, nearest: HashMap::new() }
    }

    /// Returns the red, green and blue of all colours, one after the other.
    pub fn bytes(&self) -> Vec<u8> {
        self.colours.as_flattened().to_vec()
    }

    /// Returns the places of the colours that are nearest to those of pixels, of which each has four bytes. Pixels at the
    /// edges of a picture are not opaque, and are laid on white.
    pub fn places(&mut self, pixels: &[u8]) -> Vec<u8> {
        let Self { colours, nearest } = self;
        let (mut last, mut place) = ([0; 3], None);
        let places = pixels.as_chunks::<4>().0.iter().map(|&[red, green, blue, opacity]| {
            let pixel = match opacity {
                255 => [red, green, blue],
                part => blend([255; 3], [red, green, blue], usize::from(part), 255),
            };
            // Neighbours often have one colour.
            match place {
                Some(place) if pixel == last => place,
                _ => {
                    let found = *nearest.entry(pixel).or_insert_with(|| search(colours, pixel));
                    (last, place) = (pixel, Some(found));
                    found
                }
            }
        });
        places.collect()
    }
}

/// Returns the place of the nearest colour.
fn search(colours: &[[u8; 3]], pixel: [u8; 3]) -> u8 {
    let distance = |colour: &[u8; 3]| -> u32 {
        let parts = colour.iter().zip(pixel).map(|(a, b)| u32::from(a.abs_diff(b)));
        parts.map(|part| part * part).sum()
    };
    let nearest = colours.iter().enumerate().min_by_key(|(_, colour)| distance(colour));
    nearest.map_or(0, |(place, _)| place as u8)
}

/// Returns the colour that is so many of all parts of the way to another.
fn blend(from: [u8; 3], to: [u8; 3], part: usize, all: usize) -> [u8; 3] {
    let along = part as f64 / all as f64;
    let one = |from: u8, to: u8| (f64::from(from) * (1.0 - along) + f64::from(to) * along).round();
    [0, 1, 2].map(|i| one(from[i], to[i]) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_of_pictures_are_in_the_palette_or_near_it() {
        let mut palette = FilmPalette::new();
        assert!(palette.colours.len() <= usize::from(FilmPalette::CLEAR));
        let mut found = |[red, green, blue]: [u8; 3], opacity: u8| {
            let place = palette.places(&[red, green, blue, opacity])[0];
            palette.colours[usize::from(place)]
        };
        for exact in [[0; 3], [255; 3], SIGNS[0], SIGNS[1], colour(0.0), colour(1.0)] {
            assert_eq!(found(exact, 255), exact);
            assert_eq!(found(exact, 0), [255; 3]);
        }
        for along in 0..=1000 {
            let shade = colour(f64::from(along) / 1000.0);
            let far = found(shade, 255).into_iter().zip(shade).map(|(a, b)| a.abs_diff(b)).max();
            assert!(far <= Some(3), "{shade:?}");
        }
    }
}
