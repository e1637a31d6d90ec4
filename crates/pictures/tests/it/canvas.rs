//! What plotters draws on a canvas.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::cell::RefCell;
use std::rc::Rc;
use svg_pictures::{Picture, PictureError, SvgCanvas, SvgElement, boxes, width};

type Area = DrawingArea<SvgCanvas, plotters::coord::Shift>;

/// Returns what is drawn on a white canvas of 300 × 200.
fn drawn(draw: impl FnOnce(&Area)) -> String {
    let canvas = Rc::new(RefCell::new(SvgCanvas::new([300, 200], 1, "px")));
    let area = Area::from(&canvas);
    area.fill(&WHITE).unwrap();
    draw(&area);
    canvas.borrow().drawing()
}

/// Returns the colour of a drawing at a place; a unit has eight pixels, so that no edge of a shape is blended there.
fn colour_at(drawing: &str, [x, y]: [usize; 2]) -> [u8; 3] {
    let ([columns, _], pixels) = Picture::new(drawing).unwrap().pixels(8.0).unwrap();
    let place = 4 * ((8 * y + 4) * columns as usize + 8 * x + 4);
    [pixels[place], pixels[place + 1], pixels[place + 2]]
}

fn style(size: f64, along: HPos, upright: VPos) -> TextStyle<'static> {
    TextStyle::from(("DejaVu Sans", size).into_font()).pos(Pos::new(along, upright))
}

const RED_PIXEL: [u8; 3] = [255, 0, 0];
const WHITE_PIXEL: [u8; 3] = [255, 255, 255];

#[test]
fn shapes_are_where_they_are_drawn() {
    let style = RED.stroke_width(6);
    let [inside, beside] = [[100, 100], [100, 120]];
    type Draw<'a> = Box<dyn Fn(&Area) + 'a>;
    let shapes: [Draw<'_>; 7] = [
        Box::new(|area| area.draw(&PathElement::new([(20, 100), (200, 100)], style)).unwrap()),
        Box::new(|area| area.draw(&Rectangle::new([(90, 90), (110, 110)], RED.filled())).unwrap()),
        Box::new(|area| area.draw(&Circle::new((100, 100), 10, RED.filled())).unwrap()),
        Box::new(|area| area.draw(&Circle::new((100, 90), 10, style)).unwrap()),
        Box::new(|area| {
            area.draw(&Polygon::new([(90, 110), (110, 110), (100, 80)], RED)).unwrap();
        }),
        Box::new(|area| area.draw(&SvgElement::dots([(9, 9), (100, 100)], RED, 9.0)).unwrap()),
        Box::new(|area| {
            let lines = vec![[(90, 100), (120, 100)], [(90, 150), (120, 150)]];
            area.draw(&SvgElement::lines(lines, style)).unwrap();
        }),
    ];
    for (number, shape) in shapes.iter().enumerate() {
        let drawing = drawn(shape);
        assert_eq!(colour_at(&drawing, inside), RED_PIXEL, "{number}");
        assert_eq!(colour_at(&drawing, beside), WHITE_PIXEL, "{number}");
        // Negative control: a canvas without the shape.
        assert_eq!(colour_at(&drawn(|_| {}), inside), WHITE_PIXEL);
    }
}

#[test]
fn dashes_leave_gaps_and_colours_may_be_translucent() {
    let line = |dashes| {
        let line = SvgElement::dashed([(0, 100), (200, 100)], RED.stroke_width(8), dashes);
        drawn(|area| area.draw(&line).unwrap())
    };
    let (dashed, whole) = (line("40 20"), line(""));
    assert_eq!(
        [[20, 100], [50, 100], [80, 100]].map(|at| colour_at(&dashed, at)),
        [RED_PIXEL, WHITE_PIXEL, RED_PIXEL]
    );
    assert_eq!(colour_at(&whole, [50, 100]), RED_PIXEL);
    let half = drawn(|area| {
        area.draw(&Rectangle::new([(0, 0), (99, 99)], RED.mix(0.5).filled())).unwrap();
    });
    let [red, green, blue] = colour_at(&half, [50, 50]);
    assert!(red == 255 && green.abs_diff(128) < 3 && blue == green, "{green}");
}

/// Boxes are a line high: 0.928 and 0.236 of the size above and below its base. Places of a base have one decimal.
#[test]
fn texts_are_anchored_at_their_places_and_as_large_as_estimated() {
    let text = "mean of <tspan font-style='italic'>h</tspan> (J)";
    let long = 40.0 * width(text).unwrap();
    for (along, part) in [(HPos::Left, 0.0), (HPos::Center, 0.5), (HPos::Right, 1.0)] {
        for (upright, up) in [(VPos::Top, 0.0), (VPos::Bottom, 1.0)] {
            let style = style(40.0, along, upright);
            let drawing = drawn(|area| {
                area.draw_text(text, &style, (150, 100)).unwrap();
                let (wide, high) = area.estimate_text_size(text, &style).unwrap();
                assert_eq!(f64::from(wide), long.ceil());
                assert_eq!(high, 47, "1.164 of 40, and rounded up");
            });
            let place = &boxes(&drawing).unwrap()[0];
            assert_eq!(place.text, "mean of h (J)");
            assert!((place.left - (150.0 - part * long)).abs() < 1e-3, "{place:?}");
            let top = 100.0 - up * (1901.0 + 483.0) / 2048.0 * 40.0;
            assert!((place.top - top).abs() < 0.06, "{place:?}, not {top}");
        }
    }
    // Turned by a quarter to the left, the top of a text is on its left, and its end is above.
    let style = style(40.0, HPos::Left, VPos::Top).transform(FontTransform::Rotate270);
    let turned = drawn(|area| area.draw_text(text, &style, (100, 190)).unwrap());
    let place = &boxes(&turned).unwrap()[0];
    assert!((place.left - 100.0).abs() < 0.06 && (place.bottom - 190.0).abs() < 1e-3);
    assert!((place.top - (190.0 - long)).abs() < 1e-3, "{place:?}");
}

#[test]
fn cells_fill_their_rectangle() {
    let colours = [RED_PIXEL, [0, 0, 255], [0, 255, 0], [9, 9, 9]];
    // From the lower right to the upper left, as a chart may have its corners.
    let cells = SvgElement::cells([(200, 150), (100, 50)], [2, 2], colours).unwrap();
    let drawing = drawn(|area| area.draw(&cells).unwrap());
    let places = [[125, 75], [175, 75], [125, 125], [175, 125]];
    assert_eq!(places.map(|at| colour_at(&drawing, at)), colours);
    assert_eq!(colour_at(&drawing, [90, 75]), WHITE_PIXEL);
    // Cells without a colour are clear.
    let one = SvgElement::cells([(0, 0), (200, 100)], [2, 1], [RED_PIXEL]).unwrap();
    let drawing = drawn(|area| area.draw(&one).unwrap());
    assert_eq!([[50, 50], [150, 50]].map(|at| colour_at(&drawing, at)), [RED_PIXEL, WHITE_PIXEL]);
    for size in [[0, 3], [u32::MAX, u32::MAX]] {
        let refused = SvgElement::cells([(0, 0), (9, 9)], size, []);
        assert!(matches!(refused, Err(PictureError::Pixels { scale: 1.0, .. })), "{size:?}");
    }
}

#[test]
fn a_drawing_is_as_large_as_its_units() {
    let drawing = SvgCanvas::new([12_000, 6_900], 100, "mm").drawing();
    assert!(drawing.contains("width=\"120mm\" height=\"69mm\" viewBox=\"0 0 12000 6900\""));
    // A text that is no text is an error where its size is asked for, and where it is read.
    let drawing = drawn(|area| {
        let style = style(9.0, HPos::Left, VPos::Top);
        assert!(area.estimate_text_size("a < b", &style).is_err());
        area.draw_text("a < b", &style, (9, 9)).unwrap();
    });
    assert!(matches!(Picture::new(&drawing), Err(PictureError::Xml { .. })));
    assert!(width("a &lt; b").is_ok());
}

/// The description goes into the picture, with signs of XML, and without italics.
#[test]
fn a_description_stays_in_the_picture() {
    let words = "<tspan font-style='italic'>h</tspan> = a &lt; b &amp; c";
    let canvas = SvgCanvas::new([10, 10], 1, "px").described(words).unwrap();
    let svg = Picture::new(&canvas.drawing()).unwrap().svg();
    assert!(svg.contains("<desc>h = a &lt; b &amp; c</desc>"), "{svg}");
    assert!(Picture::new(&svg).is_ok());
    // Controls: a drawing without a description has none, and what is no XML is refused.
    let svg = Picture::new(&SvgCanvas::new([10, 10], 1, "px").drawing()).unwrap().svg();
    assert!(!svg.contains("desc"));
    assert!(SvgCanvas::new([10, 10], 1, "px").described("a < b").is_err());
}
