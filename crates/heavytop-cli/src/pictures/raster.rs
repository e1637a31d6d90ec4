//! Fields of colours, a pixel for each value.

use super::colour_scale::colour;
use super::frame::Frame;
use crate::errors::Error;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use resvg::tiny_skia::{ColorU8, Pixmap};
use std::fmt::Write;

/// Returns the range of values for colours; rounding alone does not fill it.
pub(crate) fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [least, most] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| {
        [least.min(value), most.max(value)]
    });
    let size = least.abs().max(most.abs());
    match size.is_finite() && size > 0.0 {
        true if most - least > 1e-9 * size => [least, most],
        // A constant has a scale whose numbers show what it is.
        true => [least - 1e-2 * size, most + 1e-2 * size],
        false => [-1.0, 1.0],
    }
}

/// Encodes the values as a PNG with one pixel each, as many in a row as the width. Those that are `None` are grey, from 0,
/// black, to 255, white.
pub(crate) fn pixels(
    [width, height]: [u32; 2],
    values: &[Option<f64>],
    range: Option<[f64; 2]>,
    none: u8,
) -> Result<Vec<u8>, Error> {
    let mut picture = Pixmap::new(width, height)
        .ok_or_else(|| Error::Figure(format!("{width} × {height} pixels are too many")))?;
    let [least, most] = range.unwrap_or([0.0, 1.0]);
    for (pixel, value) in picture.pixels_mut().iter_mut().zip(values) {
        let [red, green, blue] =
            value.map_or([none; 3], |value| colour((value - least) / (most - least)));
        *pixel = ColorU8::from_rgba(red, green, blue, 255).premultiply();
    }
    picture.encode_png().map_err(|error| Error::Figure(error.to_string()))
}

/// Draws an image from the top to the bottom of a frame, between these edges.
pub(crate) fn image(svg: &mut String, frame: &Frame, across: (f64, f64), png: &[u8]) {
    image_at(svg, across, (frame.top, frame.bottom), png);
}

/// Draws an image between these edges.
pub(crate) fn image_at(
    svg: &mut String,
    (left, right): (f64, f64),
    (top, bottom): (f64, f64),
    png: &[u8],
) {
    // Writing to a string does not fail.
    let (width, height) = (right - left, bottom - top);
    let _ = write!(
        svg,
        "<image x=\"{left:.0}\" y=\"{top:.0}\" width=\"{width:.0}\" height=\"{height:.0}\" \
         preserveAspectRatio=\"none\" image-rendering=\"optimizeSpeed\" \
         href=\"data:image/png;base64,{}\"/>",
        STANDARD.encode(png)
    );
}

/// Draws the colours of a bar, the largest value above.
///
/// # Errors
/// If they cannot be encoded.
pub(crate) fn bar(svg: &mut String, frame: &Frame, [least, most]: [f64; 2]) -> Result<(), Error> {
    let values = (1..=256).map(|n| Some(most + (least - most) * f64::from(n) / 256.0));
    let values: Vec<Option<f64>> = values.collect();
    image(svg, frame, frame.bar(), &pixels([1, 256], &values, Some([least, most]), 0)?);
    Ok(())
}
