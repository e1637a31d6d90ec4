//! A drawing with its text as outlines.

use super::pixels::{draw, has_images, invalid};
use crate::error::PictureError;
use crate::lettering::description::{described, description};
use crate::lettering::outlines::outlined;
use resvg::tiny_skia::{Pixmap, Transform};
use usvg::{Options, Tree, WriteOptions};

/// A drawing with its text as outlines.
///
/// # Examples
/// ```
/// use svg_pictures::Picture;
///
/// let picture = Picture::new(
///     r#"<svg xmlns="http://www.w3.org/2000/svg" width="90" height="30">
///          <text x="5" y="20" font-style="italic">h</text></svg>"#,
/// )?;
/// assert!(picture.svg().contains("<path") && !picture.svg().contains("<text"));
/// assert!(picture.png(2.0)?.starts_with(b"\x89PNG"));
/// # Ok::<(), svg_pictures::PictureError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Picture {
    tree: Tree,
    /// The characters of the element `desc` of the drawing.
    description: Option<String>,
}

impl Picture {
    /// Reads a drawing, whose text becomes outlines.
    ///
    /// # Errors
    /// As [`outlined`], and [`PictureError::Svg`] if the drawing is no SVG, has no size, or elements too deep within
    /// others.
    pub fn new(drawing: &str) -> Result<Self, PictureError> {
        let tree = Tree::from_str(&outlined(drawing)?, &Options::default()).map_err(invalid)?;
        Ok(Self { tree, description: described(drawing)? })
    }

    /// Returns the picture as SVG, without text and style sheets; paths have two decimals. The description of the drawing, an
    /// element `desc` in the outermost one, stays.
    pub fn svg(&self) -> String {
        let writing = WriteOptions { coordinates_precision: 2, ..WriteOptions::default() };
        let svg = self.tree.to_string(&writing);
        let Some(words) = &self.description else { return svg };
        let words = description(words);
        match svg.split_once('>') {
            // A drawing of nothing.
            Some((head, rest)) if head.ends_with('/') => {
                format!("{}>{words}</svg>{rest}", head.trim_end_matches('/'))
            }
            Some((head, rest)) => format!("{head}>\n    {words}{rest}"),
            None => svg,
        }
    }

    /// Returns the picture as PNG with `scale` pixels per unit of its width and height.
    ///
    /// # Errors
    /// [`PictureError::Pixels`] for a scale at which there are no pixels, or too many, and [`PictureError::Svg`] for
    /// images in the drawing other than PNG, and those that are clipped, masked, filtered or translucent.
    pub fn png(&self, scale: f32) -> Result<Vec<u8>, PictureError> {
        self.drawn(scale)?.encode_png().map_err(invalid)
    }

    /// Returns the width and the height in pixels, with `scale` pixels per unit, and the red, green, blue and opacity of each
    /// pixel in rows from the top, for other formats than PNG.
    ///
    /// # Errors
    /// Those of [`png`](Self::png).
    ///
    /// # Examples
    /// ```
    /// use svg_pictures::Picture;
    ///
    /// let picture = Picture::new(
    ///     r##"<svg xmlns="http://www.w3.org/2000/svg" width="2" height="1">
    ///          <rect width="2" height="1" fill="#ff0080"/></svg>"##,
    /// )?;
    /// let (size, pixels) = picture.pixels(1.0)?;
    /// assert_eq!((size, pixels), ([2, 1], [255, 0, 128, 255].repeat(2)));
    /// # Ok::<(), svg_pictures::PictureError>(())
    /// ```
    pub fn pixels(&self, scale: f32) -> Result<([u32; 2], Vec<u8>), PictureError> {
        let pixels = self.drawn(scale)?;
        Ok(([pixels.width(), pixels.height()], pixels.take_demultiplied()))
    }

    fn drawn(&self, scale: f32) -> Result<Pixmap, PictureError> {
        let size = self.tree.size();
        let refused = || PictureError::Pixels { width: size.width(), height: size.height(), scale };
        let count = size.to_int_size().scale_by(scale).ok_or_else(refused)?;
        let mut pixels = Pixmap::new(count.width(), count.height()).ok_or_else(refused)?;
        let transform = Transform::from_scale(scale, scale);
        match has_images(self.tree.root()) {
            true => draw(self.tree.root(), transform, &mut pixels)?,
            false => resvg::render(&self.tree, transform, &mut pixels.as_mut()),
        }
        Ok(pixels)
    }
}
