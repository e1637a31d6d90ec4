//! Attributes of texts, their own and those of the elements around them.
//!
//! Source: *Scalable Vector Graphics (SVG) 2*, §11, and §4.2 for the units.

use crate::error::PictureError;
use roxmltree::Node;
use std::str::FromStr;
use svgtypes::{Length, LengthUnit};

/// The size of text that has none.
const SIZE: f64 = 12.0;

/// Attributes that set the letters in a way that this crate does not know.
const UNSUPPORTED: [&str; 19] = [
    "alignment-baseline",
    "baseline-shift",
    "direction",
    "dominant-baseline",
    "font",
    "font-stretch",
    "font-variant",
    "font-weight",
    "glyph-orientation-vertical",
    "kerning",
    "lengthAdjust",
    "letter-spacing",
    "rotate",
    "style",
    "text-decoration",
    "textLength",
    "unicode-bidi",
    "word-spacing",
    "writing-mode",
];

/// Values that such an attribute has where it changes nothing.
const USUAL: [&str; 4] = ["normal", "auto", "none", "inherit"];

/// Returns the value of an attribute of an element, or of the nearest one around it.
pub(super) fn inherited<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let values = node.ancestors().filter_map(|node| node.attribute(name));
    values.map(str::trim).find(|value| *value != "inherit")
}

/// Returns an error if an element or one around it has an attribute that this crate does not know.
pub(super) fn check(text: Node<'_, '_>) -> Result<(), PictureError> {
    for node in text.ancestors() {
        let unknown = node.attributes().find(|attribute| {
            UNSUPPORTED.contains(&attribute.name()) && !USUAL.contains(&attribute.value().trim())
        });
        if let Some(attribute) = unknown {
            return Err(unsupported(node, attribute.name()));
        }
    }
    Ok(())
}

pub(super) fn unsupported(node: Node<'_, '_>, attribute: &str) -> PictureError {
    PictureError::Unsupported {
        element: node.tag_name().name().into(),
        attribute: attribute.into(),
    }
}

/// Returns the size of the letters of a text.
pub(super) fn size(text: Node<'_, '_>) -> Result<f64, PictureError> {
    const EXPECTED: &str =
        "a size of letters: a number that is not negative, or such a number and px";
    let Some(value) = inherited(text, "font-size") else { return Ok(SIZE) };
    let size = Length::from_str(value).ok().filter(|size| size.number >= 0.0);
    match size {
        Some(Length { number, unit: LengthUnit::None | LengthUnit::Px }) => Ok(number),
        _ => Err(invalid("font-size", value, EXPECTED)),
    }
}

/// Returns a length that is an attribute of a text with letters of this size; 0 if it has none.
pub(super) fn length(
    text: Node<'_, '_>,
    name: &'static str,
    size: f64,
) -> Result<f64, PictureError> {
    let Some(value) = text.attribute(name) else { return Ok(0.0) };
    let invalid = || invalid(name, value, "a number, or a number and px, em or ex");
    let Length { number, unit } = Length::from_str(value.trim()).map_err(|_| invalid())?;
    match unit {
        LengthUnit::None | LengthUnit::Px => Ok(number),
        LengthUnit::Em => Ok(number * size),
        // As where the height of the letter x is not known.
        LengthUnit::Ex => Ok(number * size / 2.0),
        _ => Err(invalid()),
    }
}

/// Returns the part of the text that is left of its place.
pub(super) fn anchor(text: Node<'_, '_>) -> Result<f64, PictureError> {
    match inherited(text, "text-anchor") {
        None | Some("start") => Ok(0.0),
        Some("middle") => Ok(0.5),
        Some("end") => Ok(1.0),
        Some(value) => Err(invalid("text-anchor", value, "start, middle or end")),
    }
}

/// Returns whether the letters in an element are oblique.
pub(super) fn is_oblique(element: Node<'_, '_>) -> Result<bool, PictureError> {
    match inherited(element, "font-style") {
        None | Some("normal") => Ok(false),
        Some("italic" | "oblique") => Ok(true),
        Some(value) => Err(invalid("font-style", value, "normal, italic or oblique")),
    }
}

/// Returns an error for a value of an attribute.
pub(super) fn invalid(
    attribute: &'static str,
    value: &str,
    expected: &'static str,
) -> PictureError {
    PictureError::Attribute { attribute, value: value.into(), expected }
}
