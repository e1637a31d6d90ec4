//! The frame of a picture: a field between two axes and a bar of colours, with margins that their labels need.

use super::scale::Scale;
use super::scaled_chart::{Chart, TEXT, below, beside, draw_axes, rule};
use super::sheet::{Area, EDGE, Sheet, text};
use crate::errors::Error;
use crate::pictures::lettering::fitting;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use svg_pictures::SvgElement;

/// The width of the picture, in units of 0.01 mm.
pub(crate) const WIDTH: i32 = 12_000;
/// The height of the picture.
pub(crate) const HEIGHT: i32 = 10_000;

/// The distance of the bar of colours from the field, and its width.
const BAR: [i32; 2] = [350, 300];
/// The height of the points of a bar of colours, at ends beyond which there are values.
const POINT: i32 = 320;
/// The room on the right of a field without a bar of colours.
const MARGIN: i32 = 600;

/// A sheet with a field and a bar of colours.
pub(crate) struct Frame {
    pub sheet: Sheet,
    ordinate: Scale,
    bar: Option<Scale>,
}

impl Frame {
    /// Creates the frame of a picture of this height, with this caption, ordinate and bar of colours.
    ///
    /// # Errors
    /// If the caption cannot be drawn.
    pub fn new(
        height: i32,
        caption: &[String],
        ordinate: Scale,
        bar: Option<Scale>,
    ) -> Result<Self, Error> {
        Ok(Self { sheet: Sheet::new([WIDTH, height], caption, TEXT)?, ordinate, bar })
    }

    /// Returns the room on the right of the field.
    fn room(&self) -> i32 {
        let [distance, width] = BAR;
        self.bar.as_ref().map_or(MARGIN, |bar| distance + width + beside(bar, TEXT) + EDGE)
    }

    /// Returns the length of the abscissa, as a multiple of the size of the text.
    pub fn length(&self) -> f64 {
        f64::from(WIDTH - EDGE - beside(&self.ordinate, TEXT) - self.room()) / TEXT
    }

    /// Returns the chart in the field, whose coordinates are from 0 to 1.
    ///
    /// # Errors
    /// If it has no room.
    pub fn chart(&self, abscissa: Scale) -> Result<Chart<'static>, Error> {
        let chart = ChartBuilder::on(&self.sheet.body)
            .margin_left(EDGE)
            .margin_right(self.room())
            .margin_bottom(EDGE)
            .y_label_area_size(beside(&self.ordinate, TEXT))
            .x_label_area_size(below(TEXT))
            .build_cartesian_2d(abscissa, self.ordinate.clone())?;
        Ok(chart)
    }

    /// Draws the axes of the chart and the bar with these colours of places from 0 to 1, and returns the drawing.
    ///
    /// # Errors
    /// If they cannot be drawn.
    pub fn complete(
        self,
        mut chart: Chart<'_>,
        colour: impl Fn(f64) -> [u8; 3],
    ) -> Result<String, Error> {
        draw_axes(&mut chart, TEXT, false)?;
        let room = self.room();
        if let Some(bar) = self.bar {
            let (beyond, labels, line) = (WIDTH - room + BAR[0], beside(&bar, TEXT), bar.line);
            // The title reads upwards as that of the ordinate, where plotters would write it downwards.
            let (_, height) = chart.plotting_area().dim_in_pixel();
            let size = fitting(&bar.title, TEXT, height.into());
            let style = text(size, HPos::Center, VPos::Bottom).transform(FontTransform::Rotate270);
            self.sheet.body.draw_text(&bar.title, &style, (WIDTH - EDGE, height as i32 / 2))?;
            let bar = Scale { title: String::new(), ..bar };
            let [low, high] = bar.beyond.map(|is_beyond| if is_beyond { POINT } else { 0 });
            let mut chart = ChartBuilder::on(&self.sheet.body)
                .margin_left(beyond)
                .margin_right(EDGE)
                .margin_top(high)
                .margin_bottom(EDGE + below(TEXT) + low)
                .right_y_label_area_size(labels)
                .build_cartesian_2d(Scale::default(), bar)?;
            let shades = (1..=256).rev().map(|n| colour((f64::from(n) - 0.5) / 256.0));
            chart.draw_series([SvgElement::cells([(0.0, 1.0), (1.0, 0.0)], [1, 256], shades)?])?;
            if let Some(along) = line {
                // The colours of the scale are dark at one end and light at the other: both lines together show.
                for style in [WHITE.stroke_width(84), BLACK.stroke_width(28)] {
                    chart.draw_series([PathElement::new([(0.0, along), (1.0, along)], style)])?;
                }
            }
            draw_axes(&mut chart, TEXT, false)?;
            let (left, right) = (beyond, beyond + BAR[1]);
            for (end, base, height) in [(0.0, height as i32 - low, low), (1.0, high, -high)] {
                let corners = [(left, base), (right, base), ((left + right) / 2, base + height)];
                draw_point(&self.sheet.body, corners, colour(end))?;
            }
        }
        Ok(self.sheet.drawing())
    }
}

/// Draws the point of a bar of colours, a triangle; nothing where it has no height.
fn draw_point(
    area: &Area,
    corners: [(i32, i32); 3],
    [red, green, blue]: [u8; 3],
) -> Result<(), Error> {
    let [first, _, tip] = corners;
    if first.1 != tip.1 {
        area.draw(&Polygon::new(corners, RGBColor(red, green, blue).filled()))?;
        let edge: Vec<_> = corners.into_iter().chain([first]).collect();
        area.draw(&PathElement::new(edge, rule()))?;
    }
    Ok(())
}
