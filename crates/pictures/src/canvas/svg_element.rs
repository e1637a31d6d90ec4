//! What plotters has no element for: [`SvgElement`].

use super::paints::{paint, painted};
use super::svg_canvas::SvgCanvas;
use crate::error::PictureError;
use crate::rendering::cells::encoded;
use plotters::element::{Drawable, PointCollection};
use plotters::style::{Color, RGBAColor, ShapeStyle};
use plotters_backend::{BackendCoord, DrawingErrorKind};

/// An element of a chart of plotters on an [`SvgCanvas`]: many lines, a dashed line, many dots, or a field of
/// cells.
///
/// # Examples
/// ```
/// use plotters::prelude::*;
/// use std::{cell::RefCell, rc::Rc};
/// use svg_pictures::{SvgCanvas, SvgElement};
///
/// let canvas = Rc::new(RefCell::new(SvgCanvas::new([200, 100], 1, "px")));
/// let area = DrawingArea::from(&canvas);
/// area.draw(&SvgElement::cells([(0, 0), (200, 100)], [2, 1], [[255, 0, 0], [0, 0, 255]])?)?;
/// area.draw(&SvgElement::lines(vec![[(0, 0), (9, 9)], [(9, 0), (0, 9)]], RED.stroke_width(2)))?;
/// area.draw(&SvgElement::dashed([(0, 0), (200, 100)], BLACK.stroke_width(2), "8 4"))?;
/// area.draw(&SvgElement::dots([(50, 60), (90, 30)], BLUE, 5.0))?;
/// assert!(canvas.borrow().drawing().contains("stroke-dasharray=\"8 4\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SvgElement<Coord> {
    points: Vec<Coord>,
    mark: Mark,
}

#[derive(Clone, Debug)]
enum Mark {
    /// Lines through so many points each.
    Lines(ShapeStyle, usize),
    Dashed(ShapeStyle, String),
    Dots(RGBAColor, f64),
    Cells(String),
}

impl<Coord> SvgElement<Coord> {
    /// Creates lines through some points each, as one path, which is drawn faster than a path for each.
    pub fn lines<const N: usize>(lines: Vec<[Coord; N]>, style: impl Into<ShapeStyle>) -> Self {
        let points = lines.into_iter().flatten().collect();
        Self { points, mark: Mark::Lines(style.into(), N) }
    }

    /// Creates a line through points with dashes and gaps of these lengths, as SVG writes them; it is whole without any.
    pub fn dashed(
        points: impl Into<Vec<Coord>>,
        style: impl Into<ShapeStyle>,
        dashes: &str,
    ) -> Self {
        let dashes = if dashes.is_empty() { "none" } else { dashes };
        Self { points: points.into(), mark: Mark::Dashed(style.into(), dashes.into()) }
    }

    /// Creates disks of a diameter about points, as one path, which is a short one for many points.
    pub fn dots(points: impl Into<Vec<Coord>>, colour: impl Color, diameter: f64) -> Self {
        Self { points: points.into(), mark: Mark::Dots(colour.to_rgba(), diameter) }
    }

    /// Creates a field of cells between two opposite corners, with a colour for each in rows from the top. Cells without a
    /// colour are clear.
    ///
    /// # Errors
    /// [`PictureError::Pixels`] if there are no cells or more than fit in memory.
    pub fn cells(
        corners: [Coord; 2],
        size: [u32; 2],
        colours: impl IntoIterator<Item = [u8; 3]>,
    ) -> Result<Self, PictureError> {
        Ok(Self { points: corners.into(), mark: Mark::Cells(encoded(size, colours)?) })
    }
}

impl<'a, Coord> PointCollection<'a, Coord> for &'a SvgElement<Coord> {
    type Point = &'a Coord;
    type IntoIter = &'a [Coord];

    fn point_iter(self) -> &'a [Coord] {
        &self.points
    }
}

impl<Coord> Drawable<SvgCanvas> for SvgElement<Coord> {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        mut points: I,
        canvas: &mut SvgCanvas,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<PictureError>> {
        match &self.mark {
            Mark::Lines(style, each) => {
                canvas.add_path(&painted(style, false), points, *each, "");
            }
            Mark::Dashed(style, dashes) => {
                let attributes = format!("{} stroke-dasharray=\"{dashes}\"", painted(style, false));
                canvas.add_path(&attributes, points, usize::MAX, "");
            }
            Mark::Dots(colour, diameter) => {
                let paint = paint("stroke", colour.to_backend_color());
                canvas.add(format_args!(
                    "<path fill=\"none\" {paint} stroke-linecap=\"round\" stroke-width=\"{diameter:.1}\" d=\""
                ));
                for (x, y) in points {
                    // Some viewers drop a line of no length.
                    canvas.add(format_args!("M{x} {y}h.1"));
                }
                canvas.add(format_args!("\"/>"));
            }
            Mark::Cells(png) => {
                if let (Some(one), Some(other)) = (points.next(), points.next()) {
                    canvas.add_cells(one, other, png);
                }
            }
        }
        Ok(())
    }
}
