//! SVG drawings with text, as SVG in which text is outlines of the font DejaVu Sans, and as PNG.
//!
//! The SVG looks the same wherever it is shown, with or without the font. The crate needs no font on the machine, and
//! compiles in a fraction of the time that libraries for any font and script take.
//!
//! ```toml
//! [dependencies]
//! svg-pictures = "0.1"
//! ```
//!
//! ```
//! use svg_pictures::{Picture, boxes, width};
//!
//! // A title as large as fits in a width of 200
//! let title = "energy <tspan font-style='italic'>h</tspan> of the top";
//! let size = 20_f64.min(200.0 / width(title)?);
//! let drawing = format!(
//!     "<svg xmlns='http://www.w3.org/2000/svg' width='220' height='40'>
//!      <rect width='220' height='40' fill='white'/>
//!      <text x='110' y='26' font-size='{size}' text-anchor='middle'>{title}</text></svg>"
//! );
//! let place = &boxes(&drawing)?[0];
//! assert!(place.left > 9.9 && place.right < 210.1);
//!
//! let picture = Picture::new(&drawing)?;
//! let (svg, png) = (picture.svg(), picture.png(2.0)?);
//! assert!(!svg.contains("<text") && png.len() > 1000);
//! # Ok::<(), svg_pictures::PictureError>(())
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a drawing as a file | [`Picture`] |
//! | a chart that the library plotters composes | [`SvgCanvas`], and [`SvgElement`] for dashes, many dots or lines, and cells |
//! | a description in words, which the picture keeps | [`SvgCanvas::described`] |
//! | room for a text before it is drawn | [`width`] |
//! | where the texts of a drawing are | [`boxes`] |
//! | a drawing without texts for another renderer | [`outlined`] |
//!
//! # What texts may have
//!
//! * The attributes `x`, `y`, `dx`, `dy` (a number each, with px, em or ex at most), `text-anchor`, `font-size` and
//!   `font-style`; the last three also in the elements around. Whatever the `font-family`, the font is DejaVu Sans.
//! * Elements `tspan` with the attribute `font-style` alone.
//! * Any attributes that do not set the letters, such as `fill`, `opacity` and `transform`.
//!
//! Whatever else would set the letters, such as `font-weight` or `rotate`, is an error. Style sheets do not reach texts.
//! Letters stand from the left to the right, with kerning and the ligatures of f. Marks are not set over letters; most
//! letters with marks are characters themselves. A character that the font lacks is an empty box.
//!
//! # Features and versions
//!
//! The crate has no features. Its canvas is for plotters 0.3. The oldest supported compiler is Rust 1.89.
//!
//! # Licence of the font
//!
//! The outlines are those of the DejaVu fonts, from the crate `dejavu`. Their licence, that of Bitstream Vera, permits
//! their use in pictures of any kind.

mod error;
mod fonts;
mod lettering;
mod rendering;
mod canvas;

pub use canvas::svg_canvas::SvgCanvas;
pub use canvas::svg_element::SvgElement;
pub use error::PictureError;
pub use lettering::boxes::{TextBox, boxes, width};
pub use lettering::outlines::outlined;
pub use rendering::picture::Picture;

/// Compiles and runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
