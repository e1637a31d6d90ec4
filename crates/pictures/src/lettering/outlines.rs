//! Texts as outlines.

use super::letters::SVG;
use super::row::row;
use super::text::{Text, read, texts, within};
use crate::error::PictureError;
use crate::fonts::outline::Segment;
use roxmltree::Node;
use std::fmt::Write;

/// The attributes that a path does not take from its text.
const OF_TEXTS: [&str; 10] = [
    "x",
    "y",
    "dx",
    "dy",
    "text-anchor",
    "font-family",
    "font-size",
    "font-style",
    "fill-rule",
    "d",
];

/// Returns the drawing with a `path` of outlines in place of each `text`.
///
/// The path has the attributes of the text that do not set its letters, such as `fill` and `transform`. All else in the
/// drawing stays as it is, byte by byte.
///
/// # Errors
/// [`PictureError::Xml`] if the drawing is not well-formed. [`PictureError::Attribute`], [`PictureError::Unsupported`],
/// [`PictureError::Element`] for a text that this crate does not read, and [`PictureError::Far`] for one that reaches
/// beyond ±10⁹.
///
/// # Examples
/// ```
/// let drawing = r#"<svg xmlns="http://www.w3.org/2000/svg" width="90" height="30">
///   <text x="5" y="20" fill="teal">Γ₃</text></svg>"#;
/// let outlined = svg_pictures::outlined(drawing)?;
/// assert!(outlined.contains("<path fill=\"teal\"") && !outlined.contains("<text"));
/// # Ok::<(), svg_pictures::PictureError>(())
/// ```
pub fn outlined(drawing: &str) -> Result<String, PictureError> {
    let document = read(drawing)?;
    let (mut outlined, mut done) = (String::with_capacity(2 * drawing.len()), 0);
    for node in texts(&document) {
        let range = node.range();
        outlined += &drawing[done..range.start];
        done = range.end;
        let outlines = outlines(&Text::new(node)?)?;
        if !outlines.is_empty() {
            add_path(node, &outlines, &mut outlined);
        }
    }
    outlined += &drawing[done..];
    Ok(outlined)
}

/// Adds the path that is drawn for a text.
fn add_path(node: Node<'_, '_>, outlines: &str, outlined: &mut String) {
    let source = node.document().input_text();
    *outlined += "<path";
    if node.parent().is_none_or(|parent| parent.default_namespace() != Some(SVG)) {
        let _ = write!(outlined, " xmlns=\"{SVG}\"");
    }
    // The prefix of a namespace may be one that the text itself declares.
    let kept = node.attributes().filter(|attribute| {
        attribute.namespace().is_none() && !OF_TEXTS.contains(&attribute.name())
    });
    for attribute in kept {
        let _ = write!(outlined, " {}", &source[attribute.range()]);
    }
    // Contours of a glyph may overlap, whatever the rule of the elements around the text.
    let _ = write!(outlined, " fill-rule=\"nonzero\" d=\"{outlines}\"/>");
}

/// Returns the outlines of the letters of a text as commands of a path; empty if it has none.
fn outlines(text: &Text) -> Result<String, PictureError> {
    let mut commands = String::new();
    if text.is_empty() {
        return Ok(commands);
    }
    let (row, width) = row(&text.letters);
    for placed in row {
        let scale = text.size / placed.face.units();
        let start = text.place[0] + text.size * (placed.start - text.anchor * width);
        // Renderers read numbers of single precision.
        let number = |coordinate| within(coordinate).map(|coordinate| coordinate as f32);
        let place = |[x, y]: [f64; 2]| {
            let place = [number(start + scale * x)?, number(text.place[1] - scale * y)?];
            Ok::<_, PictureError>(format!("{} {}", place[0], place[1]))
        };
        for segment in placed.face.outline(placed.glyph).unwrap_or_default() {
            let _ = match segment {
                Segment::Move(to) => write!(commands, "M{}", place(to)?),
                Segment::Line(to) => write!(commands, "L{}", place(to)?),
                Segment::Curve(by, to) => write!(commands, "Q{} {}", place(by)?, place(to)?),
                Segment::Close => write!(commands, "Z"),
            };
        }
    }
    Ok(commands)
}
