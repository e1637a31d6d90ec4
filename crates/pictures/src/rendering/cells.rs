//! Images of cells.

use crate::error::PictureError;
use crate::rendering::pixels::invalid;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use resvg::tiny_skia::{ColorU8, Pixmap};

/// Returns an image with a pixel for each cell, in rows from the top, as PNG in base64. Cells without a colour are clear.
pub(crate) fn encoded(
    [columns, rows]: [u32; 2],
    colours: impl IntoIterator<Item = [u8; 3]>,
) -> Result<String, PictureError> {
    let (width, height) = (columns as f32, rows as f32);
    let mut image =
        Pixmap::new(columns, rows).ok_or(PictureError::Pixels { width, height, scale: 1.0 })?;
    for (pixel, [red, green, blue]) in image.pixels_mut().iter_mut().zip(colours) {
        *pixel = ColorU8::from_rgba(red, green, blue, 255).premultiply();
    }
    Ok(STANDARD.encode(image.encode_png().map_err(invalid)?))
}
