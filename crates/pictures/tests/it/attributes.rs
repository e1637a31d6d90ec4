//! Attributes of texts, and of the elements around them.

use crate::{assert_near, drawing, outlines, place};
use svg_pictures::outlined;

/// The width of "100" and how far lines reach up and down, as parts of the size.
const WIDTH: f64 = 3.0 * 1303.0 / 2048.0;
const UP: f64 = 1901.0 / 2048.0;
const DOWN: f64 = 483.0 / 2048.0;

#[test]
fn a_text_is_anchored_at_its_start_middle_or_end() {
    for (anchor, part) in [("start", 0.0), ("middle", 0.5), ("end", 1.0)] {
        let text = format!(
            "<text x=\"400\" y=\"200\" font-size=\"50\" text-anchor=\"{anchor}\">100</text>"
        );
        let left = 400.0 - 50.0 * WIDTH * part;
        let expected = [left, 200.0 - 50.0 * UP, left + 50.0 * WIDTH, 200.0 + 50.0 * DOWN];
        assert_near(place(&text), expected, 1e-9);
        let outline = outlines(&text);
        assert!(outline[0] > left && outline[2] < left + 50.0 * WIDTH, "{anchor}: {outline:?}");
    }
}

#[test]
fn attributes_come_from_the_elements_around() {
    let own = "<text x='9' y='99' font-size='40' text-anchor='end' font-style='italic'>a</text>";
    let around = "<g font-size='40px' text-anchor='end'><g font-style='oblique' x='500'>\
                  <text x='9' y='99'>a</text></g></g>";
    let nearest = "<g font-size='7' text-anchor='middle'><text x='9' y='99' font-size='40' \
                   text-anchor='end'><tspan font-style='italic'>a</tspan></text></g>";
    let as_around = "<g font-size='40' text-anchor='end' font-style='italic'><text x='9' y='99' \
                     font-size='inherit'>a</text></g>";
    for text in [around, nearest, as_around] {
        assert_eq!(place(text), place(own), "{text}");
        assert_eq!(outlines(text), outlines(own), "{text}");
    }
    // Negative control, and a size that nothing gives is 12.
    assert_ne!(outlines(own), outlines(&own.replace("italic", "normal")));
    assert_eq!(place("<text>a</text>"), place("<text font-size='12'>a</text>"));
}

#[test]
fn offsets_have_units() {
    let at = |y: &str| place(&format!("<text x='8' font-size='20' {y}>a</text>"));
    assert_eq!(at("y='100' dy='0.5em'"), at("y='110'"));
    assert_eq!(at("y='100px' dy='1ex'"), at("y=' 110 '"));
    assert_eq!(at("y='1e2' dy='-1.5'"), at("y='98.5'"));
    assert_eq!(at("dx='3'")[0], 11.0);
}

#[test]
fn a_path_has_the_other_attributes_of_its_text() {
    let text = "<text x='5' y='9' fill='#00f' opacity=\"0.5\" id='a&quot;b' \
                transform='translate(3 4) rotate(-90)' font-family='serif'>a</text>";
    let outlined = outlined(&drawing(text)).unwrap();
    let kept = "<path fill='#00f' opacity=\"0.5\" id='a&quot;b' \
                transform='translate(3 4) rotate(-90)' fill-rule=\"nonzero\" d=\"M";
    assert!(outlined.contains(kept), "{outlined}");
}

#[test]
fn boxes_follow_transforms() {
    let text = |transform: &str| {
        place(&format!(
            "<g transform='translate(100, 50)'><text x='10' font-size='10' transform='{transform}'>\
             100</text></g>"
        ))
    };
    let [up, down, right] = [10.0 * UP, 10.0 * DOWN, 10.0 + 10.0 * WIDTH];
    assert_near(
        text("scale(2)"),
        [120.0, 50.0 - 2.0 * up, 100.0 + 2.0 * right, 50.0 + 2.0 * down],
        1e-9,
    );
    // A quarter turn to the left: what was right is up.
    assert_near(text("rotate(-90)"), [100.0 - up, 50.0 - right, 100.0 + down, 40.0], 1e-9);
    assert_near(text("rotate(90, 10, 0)"), [110.0 - down, 50.0, 110.0 + up, 40.0 + right], 1e-9);
}

/// A drawing in which SVG is not the namespace without prefix, and one that the text declares itself.
#[test]
fn namespaces_may_have_prefixes() {
    let svg = "http://www.w3.org/2000/svg";
    for drawing in [
        format!("<s:svg xmlns:s='{svg}'><s:text y='20' fill='red'>a</s:text></s:svg>"),
        format!("<drawing><text xmlns='{svg}' y='20' fill='red'>a</text></drawing>"),
        format!("<text xmlns='{svg}' y='20' fill='red'>a</text>"),
    ] {
        let outlined = outlined(&drawing).unwrap();
        let document = roxmltree::Document::parse(&outlined).unwrap();
        let paths = document.descendants().filter(|node| node.has_tag_name((svg, "path")));
        let fills: Vec<_> = paths.map(|path| path.attribute("fill")).collect();
        assert_eq!(fills, [Some("red")], "{outlined}");
    }
}
