//! The frame of a picture: captions, two axes and a bar of colours, with margins that their labels need.

use super::lettering::{FONT, fitting, lines};
use super::scale::Scale;
use std::fmt::Write;

/// The width of the picture, in units of 0.01 mm.
pub(crate) const WIDTH: f64 = 12_000.0;
/// The height of the picture.
pub(crate) const HEIGHT: f64 = 10_000.0;

/// The size of the text, 8 pt.
pub(crate) const TEXT: f64 = 282.0;
const RULE: f64 = 14.0;
/// The distance from line to line of the caption.
const LINE: f64 = 380.0;
/// The distance of the caption and of titles from the edge.
pub(crate) const EDGE: f64 = 120.0;
/// The heights above and below the baseline that letters need, as multiples of their size.
const ASCENT: f64 = 0.93;
const DESCENT: f64 = 0.24;
/// The distance of labels from the axis.
const GAP: f64 = 150.0;
/// The distances of the bar of colours from the picture: of its left and of its right edge.
const BAR: (f64, f64) = (350.0, 650.0);
/// The space below the abscissa.
const BELOW: f64 = 1100.0;
/// The space between panels.
const BETWEEN: f64 = 300.0;

/// The place of the picture's field, between its axes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Frame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
    height: f64,
    caption: Vec<String>,
    ordinate: Scale,
    bar: Option<Scale>,
}

impl Frame {
    /// Creates the frame of a picture with this caption, ordinate and bar of colours.
    pub fn new(caption: &[String], ordinate: Scale, bar: Option<Scale>) -> Self {
        Self::of_height(HEIGHT, caption, ordinate, bar)
    }

    /// Creates the frame of a picture of this height.
    pub fn of_height(height: f64, caption: &[String], ordinate: Scale, bar: Option<Scale>) -> Self {
        let caption = lines(caption, (WIDTH - 4.0 * EDGE) / TEXT);
        let left = left(ordinate.label_width());
        let beside = bar.as_ref().map_or(600.0, |bar| {
            BAR.1 + GAP + bar.label_width() * TEXT + EDGE + (ASCENT + DESCENT) * TEXT + EDGE
        });
        let top = 2.0 * EDGE + LINE * caption.len() as f64;
        let (right, bottom) = (WIDTH - beside, height - BELOW);
        Self { left, top, right, bottom, height, caption, ordinate, bar }
    }

    /// Creates the frames of panels one above the other in a picture of this height, with so much room on their right.
    pub fn stacked(
        height: f64,
        caption: &[String],
        ordinates: Vec<Scale>,
        beside: f64,
    ) -> Vec<Self> {
        let caption = lines(caption, (WIDTH - 4.0 * EDGE) / TEXT);
        let left = left(ordinates.iter().map(Scale::label_width).fold(0.0, f64::max));
        let (right, above) = (WIDTH - beside, 2.0 * EDGE + LINE * caption.len() as f64);
        let step = (height - BELOW + BETWEEN - above) / ordinates.len().max(1) as f64;
        let frame = |(row, ordinate): (usize, Scale)| {
            let top = above + step * row as f64;
            let caption = if row == 0 { caption.clone() } else { Vec::new() };
            let bottom = top + step - BETWEEN;
            Self { left, top, right, bottom, height, caption, ordinate, bar: None }
        };
        ordinates.into_iter().enumerate().map(frame).collect()
    }

    /// Returns the length of the abscissa, as a multiple of the size of the text.
    pub fn length(&self) -> f64 {
        (self.right - self.left) / TEXT
    }

    /// Returns the left and the right edge of the bar of colours.
    pub fn bar(&self) -> (f64, f64) {
        (self.right + BAR.0, self.right + BAR.1)
    }

    /// Returns the beginning of the drawing of a frame of the usual height.
    pub fn begin() -> String {
        Self::begin_of_height(HEIGHT)
    }

    /// Returns the beginning of a drawing of this height.
    pub fn begin_of_height(height: f64) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" \
             viewBox=\"0 0 {WIDTH} {height}\" font-family=\"{FONT}\" font-size=\"{TEXT}\">\
             <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"white\"/>",
            WIDTH / 100.0,
            height / 100.0
        )
    }

    /// Draws the captions, the axes and the edge of the bar of colours.
    pub fn draw(&self, svg: &mut String, abscissa: &Scale) {
        let Self { left, top, right, bottom, height, caption, ordinate, bar } = self;
        let (middle, centre) = ((left + right) / 2.0, (top + bottom) / 2.0);
        for (row, line) in caption.iter().enumerate() {
            let y = EDGE + ASCENT * TEXT + LINE * row as f64;
            let size = fitting(line, TEXT, WIDTH - 2.0 * EDGE);
            let _ = write!(
                svg,
                "<text x=\"{}\" y=\"{y:.0}\" text-anchor=\"middle\" font-size=\"{size:.0}\">{line}</text>",
                WIDTH / 2.0
            );
        }
        let mut ticks = String::new();
        for (along, label) in &abscissa.ticks {
            let x = left + (right - left) * along;
            let _ = write!(ticks, "M{x:.0} {bottom:.0}v90");
            text(svg, x, bottom + 430.0, "middle", label);
        }
        for (along, label) in &ordinate.ticks {
            let y = bottom - (bottom - top) * along;
            let _ = write!(ticks, "M{left:.0} {y:.0}h-90");
            text(svg, left - GAP, y + 100.0, "end", label);
        }
        let size = fitting(&abscissa.title, TEXT, right - left);
        let _ = write!(
            svg,
            "<text x=\"{middle:.0}\" y=\"{}\" text-anchor=\"middle\" font-size=\"{size:.0}\">{}</text>",
            height - 2.0 * EDGE,
            abscissa.title
        );
        upright(svg, EDGE + ASCENT * TEXT, centre, &ordinate.title, bottom - top);
        outline(svg, (*left, *right), (*top, *bottom));
        if let Some(scale) = bar {
            let (from, to) = self.bar();
            for (along, label) in &scale.ticks {
                let y = bottom - (bottom - top) * along;
                let _ = write!(ticks, "M{to:.0} {y:.0}h90");
                text(svg, to + GAP, y + 100.0, "start", label);
            }
            upright(svg, WIDTH - EDGE - DESCENT * TEXT, centre, &scale.title, bottom - top);
            outline(svg, (from, to), (*top, *bottom));
            if let Some(along) = scale.line {
                let y = bottom - (bottom - top) * along;
                // The colours of the scale are dark at one end and light at the other: both lines together show.
                let _ = write!(
                    svg,
                    "<path d=\"M{from:.0} {y:.0}H{to:.0}\" stroke=\"white\" stroke-width=\"84\"/>\
                     <path d=\"M{from:.0} {y:.0}H{to:.0}\" stroke=\"black\" stroke-width=\"28\"/>"
                );
            }
        }
        let _ = write!(svg, "<path d=\"{ticks}\" stroke=\"black\" stroke-width=\"{RULE}\"/>");
    }
}

/// Returns the left edge of a field whose ordinate has labels of this width, as a multiple of their size.
fn left(labels: f64) -> f64 {
    EDGE + (ASCENT + DESCENT) * TEXT + EDGE + labels * TEXT + GAP
}

// Writing to a string does not fail.

fn text(svg: &mut String, x: f64, y: f64, anchor: &str, text: &str) {
    let _ = write!(svg, "<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"{anchor}\">{text}</text>");
}

/// Writes a title from below upwards, no longer than the axis.
fn upright(svg: &mut String, x: f64, y: f64, text: &str, length: f64) {
    let size = fitting(text, TEXT, length);
    let _ = write!(
        svg,
        "<text transform=\"translate({x:.0} {y:.0}) rotate(-90)\" text-anchor=\"middle\" \
         font-size=\"{size:.0}\">{text}</text>"
    );
}

/// Draws the edge of a field.
fn outline(svg: &mut String, (left, right): (f64, f64), (top, bottom): (f64, f64)) {
    let (width, height) = (right - left, bottom - top);
    let _ = write!(
        svg,
        "<rect x=\"{left:.0}\" y=\"{top:.0}\" width=\"{width:.0}\" height=\"{height:.0}\" fill=\"none\" \
         stroke=\"black\" stroke-width=\"{RULE}\"/>"
    );
}
