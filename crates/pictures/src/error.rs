//! Why a drawing is no picture.

use thiserror::Error;

/// Why a drawing cannot be read or drawn.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The drawing is not well-formed XML.
    #[error("the drawing is no XML: {reason}")]
    Xml {
        /// What is wrong, and in which line and column.
        reason: String,
    },
    /// The drawing is XML, but no SVG with a size.
    #[error("the drawing is no SVG: {reason}")]
    Svg {
        /// What is wrong.
        reason: String,
    },
    /// A text has an attribute with a value that this crate does not read.
    #[error("{attribute}=\"{value}\" of a text is not {expected}")]
    Attribute {
        /// The attribute.
        attribute: &'static str,
        /// Its value.
        value: String,
        /// What it may be.
        expected: &'static str,
    },
    /// A text has an attribute that would move or change its letters, and that this crate does not know.
    #[error(
        "<{element}> has the attribute {attribute}; the letters of a text are set by x, y, dx, dy, text-anchor, \
         font-size and font-style alone, those of a tspan by font-style"
    )]
    Unsupported {
        /// The element, `text`, `tspan` or one around the text.
        element: String,
        /// The attribute.
        attribute: String,
    },
    /// A text contains an element other than `tspan`.
    #[error("a text contains <{element}>, and may contain only tspan")]
    Element {
        /// The element.
        element: String,
    },
    /// A text reaches further than drawings do.
    #[error("a text reaches to the coordinate {coordinate:e}, which is not within ±{most:e}")]
    Far {
        /// The coordinate.
        coordinate: f64,
        /// The largest absolute value of a coordinate.
        most: f64,
    },
    /// The picture has more pixels than fit in memory, or none.
    #[error("a picture of {width} × {height} at {scale} pixels a unit cannot be drawn")]
    Pixels {
        /// The width of the drawing.
        width: f32,
        /// The height of the drawing.
        height: f32,
        /// The pixels per unit.
        scale: f32,
    },
}
