//! What this crate promises.
#![allow(clippy::unwrap_used)]

mod any_drawing;
mod attributes;
mod canvas;
mod files;
mod outlines;
mod refused_drawings;
mod widths;

/// Returns a drawing of 900 × 300 with this in it.
fn drawing(content: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"300\" \
         viewBox=\"0 0 900 300\">{content}</svg>"
    )
}

/// Returns the box of the only text in a drawing with this in it: left, top, right and bottom.
fn place(content: &str) -> [f64; 4] {
    let boxes = svg_pictures::boxes(&drawing(content)).unwrap();
    assert_eq!(boxes.len(), 1, "{content}");
    [boxes[0].left, boxes[0].top, boxes[0].right, boxes[0].bottom]
}

/// Returns the smallest box around the outlines in a drawing, control points included: left, top, right and bottom.
///
/// Transforms are not applied.
fn around_outlines(outlined: &str) -> [f64; 4] {
    let document = roxmltree::Document::parse(outlined).unwrap();
    let mut numbers = Vec::new();
    for commands in document.descendants().filter_map(|node| node.attribute("d")) {
        let parts = commands.split(|c: char| c.is_ascii_alphabetic() || c == ' ');
        numbers.extend(parts.filter_map(|number| number.parse::<f64>().ok()));
    }
    let far = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    numbers.chunks_exact(2).fold(far, |[left, top, right, bottom], place| {
        [left.min(place[0]), top.min(place[1]), right.max(place[0]), bottom.max(place[1])]
    })
}

/// Returns the outlines of the texts in a drawing with this in it.
fn outlines(content: &str) -> [f64; 4] {
    around_outlines(&svg_pictures::outlined(&drawing(content)).unwrap())
}

#[track_caller]
fn assert_near(found: [f64; 4], expected: [f64; 4], distance: f64) {
    let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= distance);
    assert!(is_near, "{found:?} is not {expected:?}");
}
