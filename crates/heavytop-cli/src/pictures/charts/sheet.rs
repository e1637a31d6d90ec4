//! A sheet on which plotters draws, with a caption above: [`Sheet`].

use crate::errors::Error;
use crate::pictures::lettering::{FONT, fitting, lines};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::cell::RefCell;
use std::rc::Rc;
use svg_pictures::SvgCanvas;

/// A part of a sheet. Its coordinates are in units of 0.01 mm, from its upper left corner.
pub(crate) type Area = DrawingArea<SvgCanvas, Shift>;

/// The distance of captions and titles from the edge.
pub(crate) const EDGE: i32 = 120;
/// The distance from line to line, as a multiple of the size of the text.
pub(crate) const LINE: f64 = 1.35;

/// A white sheet with a caption.
pub(crate) struct Sheet {
    canvas: Rc<RefCell<SvgCanvas>>,
    /// What is below the caption.
    pub body: Area,
}

impl Sheet {
    /// Creates a sheet of this width and height with a caption of this size, whose parts are in as few lines as have room. The
    /// drawing has the whole caption as its description.
    ///
    /// # Errors
    /// If the caption cannot be drawn.
    pub fn new([width, height]: [i32; 2], caption: &[String], size: f64) -> Result<Self, Error> {
        let sides = [width, height].map(i32::unsigned_abs);
        let whole = SvgCanvas::new(sides, 100, "mm").described(&caption.join("; "))?;
        let canvas = Rc::new(RefCell::new(whole));
        let sheet = Area::from(&canvas);
        sheet.fill(&WHITE)?;
        let room = f64::from(width - 2 * EDGE);
        let caption = lines(caption, (room - 2.0 * f64::from(EDGE)) / size);
        let below = |row: usize| EDGE + (LINE * size * row as f64) as i32;
        for (row, line) in caption.iter().enumerate() {
            let style = text(fitting(line, size, room), HPos::Center, VPos::Top);
            sheet.draw_text(line, &style, (width / 2, below(row)))?;
        }
        let (_, body) = sheet.split_vertically(below(caption.len()) + EDGE);
        Ok(Self { canvas, body })
    }

    /// Returns what has been drawn as SVG.
    pub fn drawing(&self) -> String {
        self.canvas.borrow().drawing()
    }
}

/// Returns the style of text of a size, anchored so.
pub(crate) fn text(size: f64, along: HPos, upright: VPos) -> TextStyle<'static> {
    TextStyle::from((FONT, size).into_font()).pos(Pos::new(along, upright))
}
