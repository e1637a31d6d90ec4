//! A drawing on which plotters draws: [`SvgCanvas`].

use super::paints::{paint, painted};
use crate::error::PictureError;
use crate::fonts::faces::face;
use crate::lettering::boxes::width;
use crate::lettering::description::{characters, description};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontTransform,
};
use std::fmt::Write;

/// Half of the height of a digit, as a multiple of its size: where a text has its centre.
const CENTRE: f64 = 0.365;

type Drawn = Result<(), DrawingErrorKind<PictureError>>;

/// A drawing on which the library plotters draws, as SVG that [`Picture`](crate::Picture) reads.
///
/// Its coordinates are integers, of which many make a pixel or a millimetre, so that curves are smooth. Sizes of text and
/// widths of lines are in the same units. A text is what may stand in an SVG text, as that of [`width`](crate::width): it
/// may have parts in italics, and `<` and `&` are escaped. The font is DejaVu Sans whatever the family.
///
/// # Examples
/// ```
/// use plotters::prelude::*;
/// use std::{cell::RefCell, rc::Rc};
/// use svg_pictures::{Picture, SvgCanvas};
///
/// // 60 mm × 40 mm, in units of 0.01 mm
/// let canvas = Rc::new(RefCell::new(SvgCanvas::new([6000, 4000], 100, "mm")));
/// let area = DrawingArea::from(&canvas);
/// let mut chart = ChartBuilder::on(&area)
///     .margin(300)
///     .x_label_area_size(600)
///     .y_label_area_size(800)
///     .build_cartesian_2d(0.0..1.0, -1.0..1.0)?;
/// chart.configure_mesh().label_style(("DejaVu Sans", 250)).draw()?;
/// let points = (0..=100).map(|i| f64::from(i) / 100.0).map(|t| (t, (6.0 * t).sin()));
/// chart.draw_series(LineSeries::new(points, BLUE.stroke_width(20)))?;
/// let picture = Picture::new(&canvas.borrow().drawing())?;
/// assert!(picture.png(1.0)?.starts_with(b"\x89PNG"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SvgCanvas {
    size: [u32; 2],
    /// The first tag.
    head: String,
    /// The element that describes the drawing, if there is one.
    description: String,
    content: String,
}

impl SvgCanvas {
    /// Creates an empty drawing of this width and height, in units of which so many are as long as a `unit` of CSS, such as
    /// `"mm"` or `"px"`.
    pub fn new([width, height]: [u32; 2], count: u32, unit: &str) -> Self {
        let long = |length: u32| f64::from(length) / f64::from(count.max(1));
        let head = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}{unit}\" height=\"{}{unit}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"DejaVu Sans\">",
            long(width),
            long(height)
        );
        Self { size: [width, height], head, description: String::new(), content: String::new() }
    }

    /// Describes the drawing in words, which programs that read pictures aloud say, and search finds. The text is what may
    /// stand in an SVG text, of which italics are dropped.
    ///
    /// # Errors
    /// [`PictureError::Xml`] if the text is not well-formed.
    pub fn described(mut self, text: &str) -> Result<Self, PictureError> {
        self.description = description(&characters(text)?);
        Ok(self)
    }

    /// Returns what has been drawn as SVG.
    pub fn drawing(&self) -> String {
        format!("{}{}{}</svg>", self.head, self.description, self.content)
    }

    /// Adds an element. Writing to a string does not fail.
    pub(super) fn add(&mut self, element: std::fmt::Arguments<'_>) {
        let _ = self.content.write_fmt(element);
    }

    /// Adds a path of lines through so many points each, round at their corners, with these attributes and this end.
    pub(super) fn add_path(
        &mut self,
        attributes: &str,
        points: impl IntoIterator<Item = BackendCoord>,
        each: usize,
        end: &str,
    ) {
        self.add(format_args!("<path {attributes} stroke-linejoin=\"round\" d=\""));
        for (number, (x, y)) in points.into_iter().enumerate() {
            let command = if number.is_multiple_of(each) { 'M' } else { 'L' };
            self.add(format_args!("{command}{x} {y}"));
        }
        self.add(format_args!("{end}\"/>"));
    }

    /// Adds an image of cells, a PNG in base64, between two corners.
    pub(super) fn add_cells(&mut self, one: BackendCoord, other: BackendCoord, png: &str) {
        let (left, right) = (one.0.min(other.0), one.0.max(other.0));
        let (top, bottom) = (one.1.min(other.1), one.1.max(other.1));
        self.add(format_args!(
            "<image x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
             image-rendering=\"optimizeSpeed\" href=\"data:image/png;base64,{png}\"/>",
            right.saturating_sub(left),
            bottom.saturating_sub(top)
        ));
    }
}

impl DrawingBackend for SvgCanvas {
    type ErrorType = PictureError;

    fn get_size(&self) -> (u32, u32) {
        self.size.into()
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, colour: BackendColor) -> Drawn {
        self.draw_rect((x, y), (x.saturating_add(1), y.saturating_add(1)), &colour, true)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        is_filled: bool,
    ) -> Drawn {
        self.add(format_args!(
            "<rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" {}/>",
            right.saturating_sub(left),
            bottom.saturating_sub(top),
            painted(style, is_filled)
        ));
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        self.add_path(&painted(style, false), path, usize::MAX, "");
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        (x, y): BackendCoord,
        radius: u32,
        style: &S,
        is_filled: bool,
    ) -> Drawn {
        let paint = painted(style, is_filled);
        self.add(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {paint}/>"));
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Drawn {
        self.add_path(&painted(style, true), corners, usize::MAX, "Z");
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        (x, y): BackendCoord,
    ) -> Drawn {
        let (size, anchor) = (style.size(), style.anchor());
        let [ascent, descent] = extent();
        let along = match anchor.h_pos {
            HPos::Left => "start",
            HPos::Center => "middle",
            HPos::Right => "end",
        };
        let base = size
            * match anchor.v_pos {
                VPos::Top => ascent,
                VPos::Center => CENTRE,
                VPos::Bottom => -descent,
            };
        let turn = match style.transform() {
            FontTransform::None => 0,
            FontTransform::Rotate90 => 90,
            FontTransform::Rotate180 => 180,
            FontTransform::Rotate270 => 270,
        };
        let place = match turn {
            0 => format!("x=\"{x}\" y=\"{:.1}\"", f64::from(y) + base),
            _ => format!("transform=\"translate({x} {y}) rotate({turn})\" y=\"{base:.1}\""),
        };
        let (fill, slant) = (paint("fill", style.color()), style.style());
        self.add(format_args!(
            "<text {place} font-size=\"{size:.1}\" font-style=\"{}\" text-anchor=\"{along}\" {fill}>{text}</text>",
            slant.as_str()
        ));
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<PictureError>> {
        let width = width(text).map_err(DrawingErrorKind::DrawingError)?;
        let [ascent, descent] = extent();
        let whole = |part: f64| (style.size() * part).ceil() as u32;
        Ok((whole(width), whole(ascent + descent)))
    }
}

/// Returns how far lines of text reach above and below their base, in multiples of their size.
fn extent() -> [f64; 2] {
    face(false).map_or([1.0, 0.0], |face| face.extent())
}
