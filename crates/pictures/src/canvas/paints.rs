//! Attributes that fill and stroke, as SVG writes them.

use plotters_backend::{BackendColor, BackendStyle};

/// Returns the attributes of an area, or of a line around it.
pub(super) fn painted<S: BackendStyle>(style: &S, is_filled: bool) -> String {
    if is_filled {
        return paint("fill", style.color());
    }
    let (paint, width) = (paint("stroke", style.color()), style.stroke_width());
    format!("fill=\"none\" {paint} stroke-width=\"{width}\"")
}

/// Returns a colour as the value of `fill` or `stroke`, with its opacity.
pub(super) fn paint(
    attribute: &str,
    BackendColor { alpha, rgb: (red, green, blue) }: BackendColor,
) -> String {
    let opacity = match alpha < 1.0 {
        true => format!(" {attribute}-opacity=\"{alpha}\""),
        false => String::new(),
    };
    format!("{attribute}=\"#{red:02x}{green:02x}{blue:02x}\"{opacity}")
}
