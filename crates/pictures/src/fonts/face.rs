//! A face of a font: glyphs of characters, their widths, and the kerning of pairs.
//!
//! Libraries for every font are not maintained (ttf-parser, RUSTSEC-2026-0192) or take a minute to compile (skrifa); the
//! two files that are read here need few of their tables.
//!
//! Source: *OpenType specification*, the tables of these names.

use super::bytes::Bytes;
use super::outline::{Segment, outline};
use std::cmp::Ordering;

/// A face in a TrueType file with a character map of format 12 and kerning of format 0, as those of DejaVu are.
#[derive(Debug)]
pub(crate) struct Face {
    characters: Bytes,
    advances: Bytes,
    /// The glyphs of which the advances are given; all others are as wide as the last of them.
    widths: u16,
    places: Bytes,
    has_long_places: bool,
    outlines: Bytes,
    pairs: Bytes,
    /// The units of the font in the size of a letter.
    units: f64,
    ascent: f64,
    descent: f64,
}

impl Face {
    /// Reads a face; `None` if a table is missing or has another format.
    pub(crate) fn new(data: &'static [u8]) -> Option<Self> {
        let (head, hhea) = (table(data, b"head")?, table(data, b"hhea")?);
        let units = f64::from(head.u16(18)?);
        Some(Self {
            characters: characters(table(data, b"cmap")?)?,
            advances: table(data, b"hmtx")?,
            widths: hhea.u16(34)?,
            places: table(data, b"loca")?,
            has_long_places: head.i16(50)? == 1,
            outlines: table(data, b"glyf")?,
            pairs: pairs(table(data, b"kern")?)?,
            units,
            ascent: f64::from(hhea.i16(4)?) / units,
            descent: -f64::from(hhea.i16(6)?) / units,
        })
    }

    /// Returns the units of the font in the size of a letter.
    pub(crate) fn units(&self) -> f64 {
        self.units
    }

    /// Returns how far lines of this face reach above and below their base, in multiples of the size.
    pub(crate) fn extent(&self) -> [f64; 2] {
        [self.ascent, self.descent]
    }

    /// Returns the glyph of a character.
    pub(crate) fn glyph(&self, character: char) -> Option<u16> {
        let code = u32::from(character);
        let group = self.characters.search(12, |group| {
            let [first, last] = [group.u32(0)?, group.u32(4)?];
            Some(match () {
                () if code < first => Ordering::Greater,
                () if code > last => Ordering::Less,
                () => Ordering::Equal,
            })
        })?;
        let glyph = group.u32(8)?.checked_add(code - group.u32(0)?)?;
        u16::try_from(glyph).ok().filter(|glyph| *glyph != 0)
    }

    /// Returns the width of a glyph in units of the font.
    pub(crate) fn advance(&self, glyph: u16) -> f64 {
        let place = glyph.min(self.widths.saturating_sub(1));
        self.advances.u16(4 * usize::from(place)).map_or(0.0, f64::from)
    }

    /// Returns by how much a pair of glyphs is further apart than their widths, in units of the font.
    pub(crate) fn kerning(&self, first: u16, second: u16) -> f64 {
        let pair = u32::from(first) << 16 | u32::from(second);
        let found = self.pairs.search(6, |record| Some(record.u32(0)?.cmp(&pair)));
        found.and_then(|record| record.i16(4)).map_or(0.0, f64::from)
    }

    /// Returns the outline of a glyph; `None` if it cannot be read.
    pub(crate) fn outline(&self, glyph: u16) -> Option<Vec<Segment>> {
        outline(glyph, &|glyph| self.data(glyph))
    }

    fn data(&self, glyph: u16) -> Option<Bytes> {
        let place = |n: usize| match self.has_long_places {
            true => self.places.u32(4 * n).and_then(|place| usize::try_from(place).ok()),
            false => self.places.u16(2 * n).map(|place| 2 * usize::from(place)),
        };
        let [start, end] = [place(usize::from(glyph))?, place(usize::from(glyph) + 1)?];
        self.outlines.part(start, end.checked_sub(start)?)
    }
}

/// Returns a table of a font.
fn table(data: &'static [u8], tag: &[u8; 4]) -> Option<Bytes> {
    let data = Bytes(data);
    let records = (0..usize::from(data.u16(4)?)).map(|n| data.part(12 + 16 * n, 16));
    let record = records.flatten().find(|record| record.0.starts_with(tag))?;
    let [start, length] = [record.u32(8)?, record.u32(12)?];
    data.part(usize::try_from(start).ok()?, usize::try_from(length).ok()?)
}

/// Returns the groups of characters in the map of all of Unicode: first and last character, and the first's glyph.
fn characters(map: Bytes) -> Option<Bytes> {
    let records = (0..usize::from(map.u16(2)?)).map(|n| map.part(4 + 8 * n, 8));
    let mut maps = records.flatten().filter_map(|record| map.from(record.u32(4)? as usize));
    let map = maps.find(|map| map.u16(0) == Some(12))?;
    map.part(16, 12 * usize::try_from(map.u32(12)?).ok()?)
}

/// Returns the pairs of the first table of kerning: two glyphs, and how much further apart they are.
fn pairs(kerning: Bytes) -> Option<Bytes> {
    // The version and the number of tables; version, length and kind of this one; the number of its pairs.
    (kerning.u16(2)? >= 1 && kerning.u16(8)? == 1).then_some(())?;
    kerning.part(18, 6 * usize::from(kerning.u16(10)?))
}
