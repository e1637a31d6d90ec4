//! Rendering of SVG: text to outlines, and SVG to PNG.

use super::lettering::OPTIONS;
use crate::Error;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Tree, WriteOptions};

/// Returns the drawing with its text as outlines, and the same as PNG with `scale` pixels per CSS pixel.
pub(crate) fn render(drawing: &str, scale: f32) -> Result<(String, Vec<u8>), Error> {
    let tree = Tree::from_str(drawing, &OPTIONS).map_err(failed)?;
    let writing = WriteOptions { coordinates_precision: 2, ..WriteOptions::default() };
    let svg = tree.to_string(&writing);

    let size = tree.size().to_int_size().scale_by(scale).ok_or_else(|| failed("no size"))?;
    let mut pixels =
        Pixmap::new(size.width(), size.height()).ok_or_else(|| failed("too many pixels"))?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    let png = pixels.encode_png().map_err(failed)?;
    Ok((svg, png))
}

fn failed(reason: impl ToString) -> Error {
    Error::Figure(reason.to_string())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_drawing_or_too_large_is_an_error() {
        let square = "<svg xmlns='http://www.w3.org/2000/svg' width='8' height='8'></svg>";
        assert!(render(square, 2.0).unwrap().1.starts_with(b"\x89PNG"));
        for (drawing, scale) in [("<svg", 2.0), (square, 1e9)] {
            assert!(matches!(render(drawing, scale), Err(Error::Figure(_))));
        }
    }
}
