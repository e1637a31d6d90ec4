//! Outlines of texts, and where they are.

use crate::{assert_near, drawing, outlines, place};
use svg_pictures::outlined;

#[test]
fn outlines_lie_in_the_box_of_their_text() {
    for (text, style) in [("0.25 kg m²", "normal"), ("Π₃ (gyr)", "normal"), ("h", "italic")] {
        let content = format!(
            "<text x=\"40\" y=\"150\" font-size=\"60\" font-style=\"{style}\">{text}</text>"
        );
        let ([left, top, right, bottom], outline) = (place(&content), outlines(&content));
        // Slanted letters reach a little beyond their width.
        let room = 0.1 * 60.0;
        assert!(outline[0] >= left - room && outline[2] <= right + room, "{text}: {outline:?}");
        assert!(outline[1] >= top && outline[3] <= bottom, "{text}: {outline:?}");
        // They fill most of the width.
        assert!(outline[2] - outline[0] > 0.8 * (right - left), "{text}: {outline:?}");
    }
}

/// Boxes of the text and around its outlines that usvg 0.49 gave with harfrust 0.12 and skrifa 0.44.
#[test]
fn outlines_are_where_another_library_puts_them() {
    let text = "<text x=\"450\" y=\"200\" font-size=\"100\" text-anchor=\"middle\">AV \
                <tspan font-style='italic'>h</tspan>₂ off</text>";
    assert_near(place(text), USVG_BOX, 1e-3);
    assert_near(outlines(text), USVG_OUTLINES, 1e-3);
    let turned = text.replacen("<text", "<text transform='rotate(-10)'", 1);
    assert_near(place(&turned), [251.2528, -9.712906, 692.5103, 179.16624], 1e-3);
    // Negative control: a text that is moved by a hundredth of its size.
    let moved = outlines(&text.replace("450", "451"));
    assert!((moved[0] - USVG_OUTLINES[0] - 1.0).abs() < 1e-3, "{moved:?}");
}

const USVG_BOX: [f64; 4] = [236.23047, 107.177734, 663.76953, 223.58398];
const USVG_OUTLINES: [f64; 4] = [237.01172, 124.02344, 665.6738, 201.41602];

/// The letter l is a rectangle: 193 to 377 wide and 1556 high, in 2048 units.
#[test]
fn a_letter_is_its_contour() {
    let outlined =
        outlined(&drawing("<text x=\"100\" y=\"200\" font-size=\"2048\">l</text>")).unwrap();
    let commands = "M293 -1356L477 -1356L477 200L293 200Z";
    assert!(outlined.contains(commands), "{outlined}");
}

#[test]
fn italics_are_another_face() {
    let outlined = |style: &str| {
        let text = format!("<text y=\"99\"><tspan font-style=\"{style}\">l</tspan></text>");
        outlined(&drawing(&text)).unwrap()
    };
    assert_eq!(outlined("italic"), outlined("oblique"));
    assert_ne!(outlined("italic"), outlined("normal"));
}

#[test]
fn a_missing_glyph_is_an_empty_box() {
    let text = |text: &str| outlined(&drawing(&format!("<text y=\"99\">{text}</text>"))).unwrap();
    let missing = text("\u{10ffff}");
    assert!(missing.contains("d=\"M"), "{missing}");
    assert_eq!(missing, text("\u{10fffe}"));
    assert_ne!(missing, text("a"));
}

#[test]
fn all_but_the_texts_stays_as_it_is() {
    let rest = "<!-- <text> --><rect width='5' height=\"7\"/><title>a &lt; b</title>\n <g/>";
    assert_eq!(outlined(&drawing(rest)).unwrap(), drawing(rest));
    let both = outlined(&drawing(&format!("{rest}<text y=\"9\">a</text>{rest}"))).unwrap();
    assert_eq!(both.matches(rest).count(), 2);
    // Texts without letters leave nothing.
    let nothing = "<text/><text x=\"3\"> </text><text font-size=\"0\">a</text>";
    assert_eq!(outlined(&drawing(nothing)).unwrap(), drawing(""));
    // Texts of another language than SVG.
    let foreign = "<text xmlns=\"http://example.org\">a</text>";
    assert_eq!(outlined(&drawing(foreign)).unwrap(), drawing(foreign));
}
