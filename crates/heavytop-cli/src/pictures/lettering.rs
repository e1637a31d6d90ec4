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

/// The largest number of lines of a caption, but for parts that are short.
const MOST_LINES: usize = 8;

/// The numbers of characters after which a part of a caption is cut: the first with which the lines are not too many.
const CUTS: [usize; 4] = [400, 200, 100, 60];

/// Joins the parts of a caption to lines of at most this width, a multiple of the size of the text. A part that is wider has
/// lines of its own. If there are too many lines, long parts end in an ellipsis.
pub(crate) fn lines(parts: &[String], most: f64) -> Vec<String> {
    let cut = |count: usize| {
        let parts: Vec<String> = parts.iter().map(|part| shortened(part, count)).collect();
        joined(&parts, most)
    };
    let mut lines = Vec::new();
    for count in CUTS {
        lines = cut(count);
        if lines.len() <= MOST_LINES {
            break;
        }
    }
    lines
}

fn joined(parts: &[String], most: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if width(&format!("{line}; {part}")) <= most => {
                *line += &format!("; {part}")
            }
            _ => lines.extend(broken(part, most)),
        }
    }
    lines
}

/// Breaks a text between words into lines of at most this width. A word that is wider has a line of its own.
fn broken(text: &str, most: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words(text) {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}")) <= most => *line += &format!(" {word}"),
            _ => lines.push(word.into()),
        }
    }
    lines
}

/// Returns the words of a text, which may contain elements in which no space is between words.
fn words(text: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0;
    text.split(move |letter| {
        depth += i32::from(letter == '<') - i32::from(letter == '>');
        letter == ' ' && depth == 0
    })
}

/// Returns the text, or its first characters and an ellipsis. It is not cut inside of an element or of a sign of SVG.
pub(crate) fn shortened(text: &str, most: usize) -> String {
    let (mut shown, mut is_mark, mut depth) = (0, false, 0_i32);
    for (place, letter) in text.char_indices() {
        if shown == most && !is_mark && depth == 0 && letter != '<' {
            return format!("{}…", &text[..place]);
        }
        match letter {
            '<' if text[place..].starts_with("</") => (is_mark, depth) = (true, depth - 1),
            '<' => (is_mark, depth) = (true, depth + 1),
            '&' => is_mark = true,
            '>' | ';' if is_mark => {
                is_mark = false;
                shown += usize::from(letter == ';');
            }
            _ if !is_mark && shown < most => shown += 1,
            _ => {}
        }
    }
    text.into()
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
        // What is wider than a line has several, between its words.
        let long = ["<tspan font-style='italic'>h</tspan> = a + b + c".to_owned()];
        let found = lines(&long, width("h = a + b"));
        assert_eq!(found, ["<tspan font-style='italic'>h</tspan> = a + b", "+ c"]);
    }

    #[test]
    fn long_parts_are_cut_with_a_mark_where_there_are_many() {
        let part = |count: usize| {
            format!("<tspan font-style='italic'>h</tspan> = {}", "x + ".repeat(count))
        };
        let few = lines(&[part(50)], 60.0).join(" ");
        assert!(!few.contains('…') && few.matches('x').count() == 50);
        let many = lines(&vec![part(500); 7], 60.0);
        assert!(many.len() <= 3 * 7 && many.iter().filter(|line| line.contains('…')).count() == 7);
        // A cut is neither inside of a sign of SVG nor of an element.
        assert_eq!(shortened("a &lt; b", 3), "a &lt;…");
        assert_eq!(shortened("<tspan>abc</tspan>d", 1), "<tspan>abc</tspan>…");
        assert_eq!(shortened("abc", 3), "abc");
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
