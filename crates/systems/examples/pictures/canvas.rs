//! A picture with a heading, drawn by plotters and written as PNG or SVG.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::cell::RefCell;
use std::error::Error;
use std::path::Path;
use std::rc::Rc;
use svg_pictures::{Picture, SvgCanvas};

/// A part of the picture. Its coordinates are integers, [`PIXEL`] to a pixel, so that curves are smooth.
pub type Area = DrawingArea<SvgCanvas, Shift>;

/// The units of an [`Area`] in a pixel of the PNG.
pub const PIXEL: i32 = 10;

/// The size of the text in pixels.
pub const TEXT: f64 = 17.0;

const HEADING: i32 = 74;

/// Returns the style of text of a size in pixels, anchored as given.
pub fn text(size: f64, colour: &'static RGBColor, anchor: (HPos, VPos)) -> TextStyle<'static> {
    let style = TextStyle::from(("DejaVu Sans", size * f64::from(PIXEL)).into_font());
    style.color(colour).pos(Pos::new(anchor.0, anchor.1))
}

/// Draws a picture of a size in pixels and writes it: as SVG if the path ends so, and else as PNG.
///
/// The heading has two lines: what is seen, and with which method, parameters and times.
///
/// # Errors
/// Returns the reason why the picture was not drawn or written.
pub fn save(
    path: &Path,
    heading: [&str; 2],
    size: [u32; 2],
    draw: impl FnOnce(&Area) -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let unit = PIXEL as u32;
    let canvas = Rc::new(RefCell::new(SvgCanvas::new(size.map(|side| side * unit), unit, "px")));
    let area = Area::from(&canvas);
    area.fill(&WHITE)?;
    let (head, body) = area.split_vertically(HEADING * PIXEL);
    let middle = (size[0] * unit / 2) as i32;
    for (line, scale, y) in [(heading[0], 1.2, 26), (heading[1], 1.0, 54)] {
        let style = text(TEXT * scale, &BLACK, (HPos::Center, VPos::Center));
        head.draw_text(line, &style, (middle, y * PIXEL))?;
    }
    draw(&body)?;
    let picture = Picture::new(&canvas.borrow().drawing())?;
    if path.extension().is_some_and(|extension| extension == "svg") {
        std::fs::write(path, picture.svg())?;
    } else {
        std::fs::write(path, picture.png(1.0)?)?;
    }
    Ok(())
}
