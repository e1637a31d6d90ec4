//! Ranges of values for colours, and fields of cells.

use super::colour_scale::colour;
use crate::errors::Error;
use svg_pictures::SvgElement;

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

/// Returns a field of cells between two corners, as many in a row as the width, in rows from the top. Those that are `None`
/// are white.
///
/// # Errors
/// If there are too many.
pub(crate) fn cells(
    corners: [(f64, f64); 2],
    size: [u32; 2],
    values: &[Option<f64>],
    [least, most]: [f64; 2],
) -> Result<SvgElement<(f64, f64)>, Error> {
    let shade = |value: f64| colour((value - least) / (most - least));
    let colours = values.iter().map(|value| value.map_or([255; 3], shade));
    Ok(SvgElement::cells(corners, size, colours)?)
}
