//! The width of texts, and the boxes that they fill.

use super::attributes::invalid;
use super::letters::SVG;
use super::row::row;
use super::text::{Text, read, texts, within};
use crate::error::PictureError;
use crate::fonts::faces::face;
use roxmltree::Node;
use std::str::FromStr;
use svgtypes::Transform;

/// The box that a text fills: as wide as the text, and as high as a line.
///
/// It is in the coordinates of the outermost element, those of its `viewBox`; y grows downwards. The box of a turned
/// text is the smallest upright one around it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct TextBox {
    /// The characters of the text.
    pub text: String,
    /// The smallest x.
    pub left: f64,
    /// The smallest y.
    pub top: f64,
    /// The largest x.
    pub right: f64,
    /// The largest y.
    pub bottom: f64,
}

/// Returns the texts of a drawing in their order, and the boxes that they fill, whether or not they are visible.
///
/// The boxes follow the attribute `transform` of the texts and of the elements around them, but not elements `svg`
/// within another.
///
/// # Errors
/// As [`outlined`](crate::outlined), and [`PictureError::Attribute`] for a `transform` that is none.
///
/// # Examples
/// ```
/// let drawing = r#"<svg xmlns="http://www.w3.org/2000/svg" width="90" height="30" font-size="10">
///   <text x="5" y="20">12</text></svg>"#;
/// let boxes = svg_pictures::boxes(drawing)?;
/// assert_eq!((boxes[0].text.as_str(), boxes[0].left), ("12", 5.0));
/// assert!((boxes[0].right - 5.0 - 2.0 * 6.362).abs() < 1e-3); // digits are 0.6362 of the size wide
/// # Ok::<(), svg_pictures::PictureError>(())
/// ```
pub fn boxes(drawing: &str) -> Result<Vec<TextBox>, PictureError> {
    let document = read(drawing)?;
    let mut boxes = Vec::new();
    for node in texts(&document) {
        let text = Text::new(node)?;
        if !text.is_empty() {
            boxes.push(text_box(node, &text)?);
        }
    }
    Ok(boxes)
}

/// Returns the width of a text, which may contain `tspan` elements, as a multiple of the size of its letters.
///
/// # Errors
/// As [`outlined`](crate::outlined), for the text as it stands in an SVG.
///
/// # Examples
/// ```
/// assert!((svg_pictures::width("10")? - 2.0 * 0.6362).abs() < 1e-4);
/// assert!(svg_pictures::width("a &lt; <tspan font-style='italic'>b</tspan>")? > 2.0);
/// # Ok::<(), svg_pictures::PictureError>(())
/// ```
pub fn width(text: &str) -> Result<f64, PictureError> {
    let drawing = format!("<text xmlns=\"{SVG}\">{text}</text>");
    let document = read(&drawing)?;
    Ok(row(&Text::new(document.root_element())?.letters).1)
}

/// Returns the box of a text.
fn text_box(node: Node<'_, '_>, text: &Text) -> Result<TextBox, PictureError> {
    let [ascent, descent] = face(false).map_or([1.0, 0.0], |face| face.extent());
    let (Text { size, place: [x, y], anchor, .. }, (_, width)) = (text, row(&text.letters));
    let [left, right] = [x - size * anchor * width, x + size * (1.0 - anchor) * width];
    let [top, bottom] = [y - size * ascent, y + size * descent];
    let mut corners = [[left, top], [right, top], [left, bottom], [right, bottom]];
    for value in node.ancestors().filter_map(|node| node.attribute("transform")) {
        let expected = "a transform, such as translate(1 2)";
        let transform =
            Transform::from_str(value).map_err(|_| invalid("transform", value, expected))?;
        corners = corners.map(|corner| moved(&transform, corner));
    }
    for coordinate in corners.as_flattened() {
        within(*coordinate)?;
    }
    let extreme = |axis: usize, of: fn(f64, f64) -> f64| {
        corners[1..].iter().fold(corners[0][axis], |so_far, corner| of(so_far, corner[axis]))
    };
    Ok(TextBox {
        text: text.content(),
        left: extreme(0, f64::min),
        top: extreme(1, f64::min),
        right: extreme(0, f64::max),
        bottom: extreme(1, f64::max),
    })
}

fn moved(transform: &Transform, [x, y]: [f64; 2]) -> [f64; 2] {
    let Transform { a, b, c, d, e, f } = *transform;
    [a * x + c * y + e, b * x + d * y + f]
}
