//! Rendering of SVG: text to outlines, and SVG to PNG and to pixels.

use crate::errors::Error;
use crate::files::{Kind, contains};
use svg_pictures::Picture;

/// The comment after the first tag of every SVG that the program writes.
const COMMENT: &str = "<!-- heavytop -->";

/// The field of every PNG that the program writes: a keyword of the standard, and its text.
const SOFTWARE: &str = "Software\0heavytop";

/// The comment of every GIF that the program writes.
pub(crate) const GIF_COMMENT: &str = "Software: heavytop";

/// The length of the signature of a PNG and of its first chunk, after which others may be.
const PNG_HEADER: usize = 8 + 25;

/// How pictures of the program are recognised.
pub(crate) const SVG: Kind<'_> = Kind {
    name: "picture of heavytop",
    first: b"<svg ",
    is_whole: |head, _| Ok(contains(head, COMMENT)),
};
pub(crate) const PNG: Kind<'_> = Kind {
    name: "picture of heavytop",
    first: b"\x89PNG\r\n\x1a\n",
    is_whole: |head, _| Ok(contains(head.get(PNG_HEADER..).unwrap_or_default(), SOFTWARE)),
};

pub(crate) const GIF: Kind<'_> = Kind {
    name: "picture of heavytop",
    first: b"GIF89a",
    is_whole: |head, _| Ok(contains(head, GIF_COMMENT)),
};

/// Returns the drawing with its text as outlines, and the same as PNG with `scale` pixels per CSS pixel.
pub(crate) fn render(drawing: &str, scale: f32) -> Result<(String, Vec<u8>), Error> {
    let picture = Picture::new(drawing)?;
    let svg = picture.svg().replacen('>', &format!(">\n    {COMMENT}"), 1);
    let png = picture.png(scale)?;
    Ok((svg, with_field(&png, SOFTWARE)))
}

/// Returns the width and the height of a drawing with `scale` pixels per CSS pixel, and its pixels, four bytes each.
pub(crate) fn pixels(drawing: &str, scale: f32) -> Result<([u32; 2], Vec<u8>), Error> {
    Ok(Picture::new(drawing)?.pixels(scale)?)
}

/// Returns the PNG with a field of text (a chunk `tEXt`) after its header.
///
/// Source: *Portable Network Graphics (PNG) Specification*, §5.3 and §11.3.4.3.
fn with_field(png: &[u8], text: &str) -> Vec<u8> {
    let (header, rest) = png.split_at(PNG_HEADER.min(png.len()));
    let field = [b"tEXt", text.as_bytes()].concat();
    let (length, checksum) = (text.len() as u32, crc32fast::hash(&field));
    [header, &length.to_be_bytes(), &field, &checksum.to_be_bytes(), rest].concat()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use resvg::tiny_skia::Pixmap;

    #[test]
    fn what_is_no_drawing_or_too_large_is_an_error() {
        let square = "<svg xmlns='http://www.w3.org/2000/svg' width='8' height='8'></svg>";
        let (svg, png) = render(square, 2.0).unwrap();
        assert!(svg.starts_with("<svg ") && Picture::new(&svg).is_ok(), "{svg}");
        // A decoder that checks the checksums reads as many pixels.
        let decoded = Pixmap::decode_png(&png).unwrap();
        assert_eq!((decoded.width(), decoded.height()), (16, 16));
        for (drawing, scale) in [("<svg", 2.0), (square, 1e9)] {
            assert!(matches!(render(drawing, scale), Err(Error::Figure(_))));
        }
    }
}
