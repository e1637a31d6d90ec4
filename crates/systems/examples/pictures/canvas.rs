//! A picture with a heading, drawn by plotters and written as PNG or SVG.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use svg_pictures::Picture;

/// A part of the picture. Its coordinates are integers, [`PIXEL`] to a pixel, so that curves are smooth.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The units of an [`Area`] in a pixel of the PNG.
pub const PIXEL: i32 = 10;

/// The size of the text in pixels.
pub const TEXT: f64 = 17.0;

const HEADING: i32 = 74;
const FONT: &str = "DejaVu Sans";

/// Cells of one colour each, below everything that plotters draws.
pub struct Image {
    /// Left, top, right and bottom in units of the whole picture.
    pub corners: [i32; 4],
    /// The cells as PNG in base64.
    pub cells: String,
}

/// Returns the style of text of a size in pixels, anchored as given.
pub fn text(size: f64, colour: &'static RGBColor, anchor: (HPos, VPos)) -> TextStyle<'static> {
    // The backend divides the size by 1.24.
    let style = TextStyle::from((FONT, size * f64::from(PIXEL) * 1.24).into_font());
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
    [width, height]: [u32; 2],
    draw: impl FnOnce(&Area<'_>) -> Result<Vec<Image>, Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let (unit, mut drawn) = (PIXEL as u32, String::new());
    let size = (width * unit, height * unit);
    let images = {
        let area = SVGBackend::with_string(&mut drawn, size).into_drawing_area();
        let (head, body) = area.split_vertically(HEADING * PIXEL);
        let middle = (size.0 / 2) as i32;
        for (line, scale, y) in [(heading[0], 1.2, 26), (heading[1], 1.0, 54)] {
            let style = text(TEXT * scale, &BLACK, (HPos::Center, VPos::Center));
            head.draw(&Text::new(line, (middle, y * PIXEL), style))?;
        }
        let images = draw(&body)?;
        area.present()?;
        images
    };
    write(path, &compose(&drawn, size, &images)?)
}

/// Puts a white ground and the images below what is drawn.
fn compose(
    drawn: &str,
    (width, height): (u32, u32),
    images: &[Image],
) -> Result<String, Box<dyn Error>> {
    let body = drawn.split_once('>').map_or("", |(_, body)| body);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {width} \
         {height}\"><rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>",
        width / PIXEL as u32,
        height / PIXEL as u32
    );
    for Image { corners: [left, top, right, bottom], cells } in images {
        write!(
            svg,
            "<image x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
             image-rendering=\"optimizeSpeed\" href=\"data:image/png;base64,{cells}\"/>",
            right - left,
            bottom - top
        )?;
    }
    // Round corners, and text in the middle of the line where that is asked for.
    svg += &body
        .replace("<polyline ", "<polyline stroke-linejoin=\"round\" ")
        .replace("dy=\"0.5ex\"", "dy=\"0.365em\"");
    Ok(svg)
}

fn write(path: &Path, svg: &str) -> Result<(), Box<dyn Error>> {
    let picture = Picture::new(svg)?;
    if path.extension().is_some_and(|extension| extension == "svg") {
        std::fs::write(path, picture.svg())?;
    } else {
        std::fs::write(path, picture.png(1.0)?)?;
    }
    Ok(())
}
