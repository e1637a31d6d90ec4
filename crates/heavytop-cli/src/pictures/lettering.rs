//! The font of pictures, the width of texts in it, and lines of text.

/// The font family of all text; the program contains its outlines.
pub(crate) const FONT: &str = "DejaVu Sans";

/// Returns the width of a text, which may contain `tspan` elements, as a multiple of its size. It is 0 for what is no
/// text, of which drawing the picture gives the error.
pub(crate) fn width(text: &str) -> f64 {
    svg_pictures::width(text).unwrap_or(0.0)
}

/// Returns the largest width of some texts.
pub(crate) fn widest<'a>(texts: impl IntoIterator<Item = &'a str>) -> f64 {
    texts.into_iter().map(width).fold(0.0, f64::max)
}

/// Returns the size at which a text is at most so long, and at most `size`.
pub(crate) fn fitting(text: &str, size: f64, length: f64) -> f64 {
    size.min(length / width(text).max(f64::MIN_POSITIVE))
}

/// Joins the parts of a caption to lines of at most this width, a multiple of the size of the text.
pub(crate) fn lines(parts: &[String], most: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if width(&format!("{line}; {part}")) <= most => {
                *line += &format!("; {part}")
            }
            _ => lines.push(part.clone()),
        }
    }
    lines
}

/// Checks of drawings: where their texts are.
#[cfg(test)]
#[allow(clippy::unwrap_used)]
pub(crate) mod checks {
    use svg_pictures::{TextBox, boxes};

    /// Returns the texts of a drawing.
    pub fn texts(drawing: &str) -> Vec<String> {
        boxes(drawing).unwrap().into_iter().map(|place| place.text).collect()
    }

    /// Returns the pairs of texts that overlap, and the texts that the edge of the drawing cuts.
    pub fn collisions(drawing: &str, (width, height): (f64, f64)) -> Vec<String> {
        let boxes = boxes(drawing).unwrap();
        assert!(!boxes.is_empty(), "no text is found");
        let mut found = Vec::new();
        for (n, place) in boxes.iter().enumerate() {
            let inside = place.left >= 0.0
                && place.top >= 0.0
                && place.right <= width
                && place.bottom <= height;
            if !inside {
                found.push(format!("cut: {}", place.text));
            }
            for other in boxes[..n].iter().filter(|other| overlap(place, other)) {
                found.push(format!("{} over {}", place.text, other.text));
            }
        }
        found
    }

    fn overlap(one: &TextBox, other: &TextBox) -> bool {
        // Boxes are a line high, with room for accents above; glyphs fill some three quarters of it.
        let room = 0.12 * (one.bottom - one.top).min(other.bottom - other.top);
        let apart = one.left > other.right
            || other.left > one.right
            || one.top > other.bottom - room
            || other.top > one.bottom - room;
        !apart
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_are_measured_in_the_font() {
        // The digits of DejaVu Sans are 0.636 wide; those of its raised digits are narrower.
        assert!((width("1234567890") - 6.36).abs() < 0.02, "{}", width("1234567890"));
        assert!(width("⁻⁴") > 0.3 && width("⁻⁴") < width("−4"));
        assert_eq!(
            width("<tspan font-style='italic'>h</tspan> (J)"),
            width("<tspan font-style='italic'>h</tspan> (J)")
        );
        assert!(width("h (J)") > 1.5);
        assert!((fitting("1234567890", 100.0, 318.0) - 50.0).abs() < 0.2);
        assert_eq!(fitting("1", 100.0, 318.0), 100.0);
    }

    #[test]
    fn captions_are_broken_between_their_parts() {
        let parts = ["one", "two", "three"].map(String::from);
        assert_eq!(lines(&parts, 100.0), ["one; two; three"]);
        assert_eq!(lines(&parts, width("one; two")), ["one; two", "three"]);
    }

    /// Negative control: the checks of pictures find texts that overlap, and texts that are cut.
    #[test]
    fn collisions_are_found() {
        let drawing = |x: f64| {
            format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 900 100\" font-size=\"30\">\
                 <text x=\"10\" y=\"50\">0.0001</text><text x=\"{x}\" y=\"50\">0.0002</text></svg>"
            )
        };
        assert_eq!(checks::collisions(&drawing(200.0), (900.0, 100.0)), [""; 0]);
        assert_eq!(checks::collisions(&drawing(100.0), (900.0, 100.0)), ["0.0002 over 0.0001"]);
        assert_eq!(checks::collisions(&drawing(880.0), (900.0, 100.0)), ["cut: 0.0002"]);
    }
}
