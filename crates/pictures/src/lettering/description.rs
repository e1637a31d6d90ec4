//! The description of a drawing in words.

use super::letters::SVG;
use super::text::read;
use crate::error::PictureError;

/// Returns the characters of a text that may stand in an SVG text.
pub(crate) fn characters(text: &str) -> Result<String, PictureError> {
    let drawing = format!("<text xmlns=\"{SVG}\">{text}</text>");
    let document = read(&drawing)?;
    let inner = document.descendants().filter_map(|node| node.is_text().then(|| node.text())?);
    Ok(inner.collect())
}

/// Returns the element that describes a drawing with these characters.
pub(crate) fn description(characters: &str) -> String {
    let escaped = characters.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    format!("<desc>{escaped}</desc>")
}

/// Returns the characters by which a drawing is described, if it is.
pub(crate) fn described(drawing: &str) -> Result<Option<String>, PictureError> {
    if !drawing.contains("<desc") {
        return Ok(None);
    }
    let document = read(drawing)?;
    let mut children = document.root_element().children();
    let found = children.find(|node| node.has_tag_name((SVG, "desc")));
    Ok(found.and_then(|node| node.text()).map(String::from))
}
