//! The letters of a text: which characters are drawn, and which of them are oblique.

use super::attributes::{is_oblique, unsupported};
use crate::error::PictureError;
use roxmltree::Node;

/// The namespace of SVG.
pub(super) const SVG: &str = "http://www.w3.org/2000/svg";

/// Characters that one glyph stands for; the longest first.
const LIGATURES: [(&str, char); 5] = [
    ("ffi", '\u{fb03}'),
    ("ffl", '\u{fb04}'),
    ("ff", '\u{fb00}'),
    ("fi", '\u{fb01}'),
    ("fl", '\u{fb02}'),
];

/// A character of a text, upright or oblique.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Letter {
    pub(super) character: char,
    pub(super) is_oblique: bool,
}

/// Returns the letters of a text. Line ends and tabs are spaces, and spaces in a row are one, unless `xml:space` keeps
/// them.
///
/// Source: *Scalable Vector Graphics (SVG) 1.1*, §10.15.
pub(super) fn letters(text: Node<'_, '_>) -> Result<Vec<Letter>, PictureError> {
    let mut letters = Vec::new();
    for node in text.descendants().skip(1) {
        if let (true, Some(content), Some(parent)) = (node.is_text(), node.text(), node.parent()) {
            let is_oblique = is_oblique(parent)?;
            letters.extend(content.chars().map(|character| Letter {
                character: if "\t\n\r".contains(character) { ' ' } else { character },
                is_oblique,
            }));
        } else if node.is_element() {
            check(node)?;
        }
    }
    if !keeps_spaces(text) {
        letters.dedup_by(|next, before| [next, before].iter().all(|l| l.character == ' '));
        letters.pop_if(|last| last.character == ' ');
        if letters.first().is_some_and(|first| first.character == ' ') {
            letters.remove(0);
        }
    }
    Ok(letters)
}

/// Returns an error if an element in a text is no `tspan`, or has more than a style.
fn check(node: Node<'_, '_>) -> Result<(), PictureError> {
    if !node.has_tag_name((SVG, "tspan")) {
        return Err(PictureError::Element { element: node.tag_name().name().into() });
    }
    match node.attributes().find(|attribute| attribute.name() != "font-style") {
        Some(attribute) => Err(unsupported(node, attribute.name())),
        None => Ok(()),
    }
}

fn keeps_spaces(text: Node<'_, '_>) -> bool {
    let space = (roxmltree::NS_XML_URI, "space");
    text.ancestors().find_map(|node| node.attribute(space)) == Some("preserve")
}

/// Returns the letters with the ligatures of Latin letters in place of what they stand for.
pub(super) fn joined(letters: &[Letter]) -> Vec<Letter> {
    let (mut joined, mut rest) = (Vec::with_capacity(letters.len()), letters);
    while let [first, after @ ..] = rest {
        let ligature = LIGATURES.iter().find(|(parts, _)| begins(rest, parts, first.is_oblique));
        let (character, after) = match ligature {
            Some((parts, ligature)) => (*ligature, &rest[parts.len()..]),
            None => (first.character, after),
        };
        joined.push(Letter { character, ..*first });
        rest = after;
    }
    joined
}

/// Returns whether letters begin with these ASCII characters, all of this slant.
fn begins(letters: &[Letter], characters: &str, is_oblique: bool) -> bool {
    letters.len() >= characters.len()
        && letters
            .iter()
            .zip(characters.chars())
            .all(|(letter, character)| *letter == Letter { character, is_oblique })
}
