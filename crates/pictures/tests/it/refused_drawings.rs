//! What is no drawing, and texts that this crate does not read.

use crate::drawing;
use svg_pictures::{Picture, PictureError, boxes, outlined, width};

/// Returns the error of a drawing, which all functions give alike.
#[track_caller]
fn refused(drawing: &str) -> PictureError {
    let error = outlined(drawing).unwrap_err();
    assert_eq!(boxes(drawing).unwrap_err(), error);
    assert_eq!(Picture::new(drawing).unwrap_err(), error);
    error
}

#[test]
fn what_is_no_xml_is_an_error() {
    for drawing in ["", "<svg", "<svg><text></svg>", "<svg>\u{0}</svg>", "<!DOCTYPE a []><svg/>"] {
        assert!(matches!(refused(drawing), PictureError::Xml { .. }), "{drawing}");
    }
    for text in ["<", "a & b", "</text><text>", "<tspan>"] {
        assert!(matches!(width(text), Err(PictureError::Xml { .. })), "{text}");
    }
    let error = refused("<svg>\n<a></svg>").to_string();
    assert!(error.starts_with("the drawing is no XML: ") && error.contains("2:"), "{error}");
}

#[test]
fn what_is_no_svg_is_an_error() {
    let namespace = "xmlns='http://www.w3.org/2000/svg'";
    for drawing in ["<a/>".into(), format!("<svg {namespace} width='-1' height='2'/>")] {
        assert!(matches!(Picture::new(&drawing), Err(PictureError::Svg { .. })), "{drawing}");
    }
}

/// Functions that call themselves for each element would overflow the stack.
#[test]
fn elements_deep_within_others_are_no_panic() {
    for depth in [500, 100_000] {
        let [before, after] = ["<g>", "</g>"].map(|tag| tag.repeat(depth));
        let drawing = drawing(&format!("{before}<text y='9'>a</text>{after}"));
        assert!(outlined(&drawing).is_ok() && boxes(&drawing).is_ok(), "{depth}");
        let picture = Picture::new(&drawing);
        match depth {
            500 => assert!(picture.unwrap().png(1.0).is_ok()),
            _ => assert!(matches!(picture, Err(PictureError::Svg { .. })), "{picture:?}"),
        }
    }
}

#[test]
fn values_of_attributes_are_named() {
    for (attribute, value) in [
        ("x", "1 2"),
        ("y", "NaN"),
        ("dx", "5%"),
        ("dy", ""),
        ("font-size", "large"),
        ("font-size", "-3"),
        ("font-size", "2em"),
        ("font-size", "1e400"),
        ("text-anchor", "left"),
        ("font-style", "slanted"),
    ] {
        let error = refused(&drawing(&format!("<text {attribute}='{value}'>a</text>")));
        let is_named = matches!(&error, PictureError::Attribute { attribute: named, value: found, .. }
            if *named == attribute && found == value);
        assert!(is_named, "{error:?}");
        let start = format!("{attribute}=\"{value}\" of a text is not ");
        assert!(error.to_string().starts_with(&start), "{error}");
    }
    let turned = drawing("<g transform='turn(3)'><text>a</text></g>");
    assert!(matches!(boxes(&turned), Err(PictureError::Attribute { .. })));
}

#[test]
fn attributes_that_would_be_ignored_are_errors() {
    for (content, element, attribute) in [
        ("<text rotate='9'>a</text>", "text", "rotate"),
        ("<g font-weight='bold'><text>a</text></g>", "g", "font-weight"),
        ("<text><tspan dy='9'>a</tspan></text>", "tspan", "dy"),
        ("<text><tspan fill='red'>a</tspan></text>", "tspan", "fill"),
    ] {
        let error = refused(&drawing(content));
        let expected =
            PictureError::Unsupported { element: element.into(), attribute: attribute.into() };
        assert_eq!(error, expected);
    }
    // Negative controls: where it changes nothing, and where there is no text.
    for content in ["<text font-weight='normal'>a</text>", "<g rotate='9'/><text>a</text>"] {
        assert!(outlined(&drawing(content)).is_ok(), "{content}");
    }
}

#[test]
fn elements_in_a_text_are_errors() {
    for element in ["a", "textPath", "text"] {
        let error = refused(&drawing(&format!("<text>a<{element}>b</{element}></text>")));
        assert_eq!(error, PictureError::Element { element: element.into() });
    }
    let foreign = drawing("<text><tspan xmlns='http://example.org'>b</tspan></text>");
    assert!(matches!(refused(&foreign), PictureError::Element { .. }));
}

#[test]
fn texts_that_reach_far_are_errors() {
    for attributes in ["font-size='1e300'", "x='-2e9'", "y='1e308' dy='1e308'", "x='1e9em'"] {
        let drawing = drawing(&format!("<text {attributes}>ab</text>"));
        for error in [outlined(&drawing).map(drop), boxes(&drawing).map(drop)] {
            let error = error.unwrap_err();
            let is_bound = matches!(error, PictureError::Far { most: 1e9, .. });
            assert!(is_bound, "{attributes}: {error}");
            assert!(error.to_string().ends_with("which is not within ±1e9"), "{error}");
        }
    }
    let scaled = drawing("<g transform='scale(1e300)'><text x='1'>a</text></g>");
    assert!(matches!(boxes(&scaled), Err(PictureError::Far { .. })));
    assert!(Picture::new(&scaled).unwrap().png(1.0).is_ok());
    // Negative control: within the bound.
    assert!(outlined(&drawing("<text x='-9e8' font-size='1e6'>ab</text>")).is_ok());
}

#[test]
fn pictures_without_pixels_or_with_too_many_are_errors() {
    let picture = Picture::new(&drawing("<text y='90'>a</text>")).unwrap();
    for scale in [0.0, -1.0, 1e9, f32::INFINITY, f32::NAN] {
        let error = picture.png(scale).unwrap_err();
        assert!(matches!(error, PictureError::Pixels { .. }), "{scale}");
        assert!(error.to_string().contains("900 × 300"), "{error}");
    }
    assert!(picture.png(0.5).is_ok());
}
