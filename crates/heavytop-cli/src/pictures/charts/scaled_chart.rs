//! Charts of plotters whose axes are scales: [`Chart`].

use super::scale::Scale;
use super::sheet::{EDGE, LINE, text};
use crate::errors::Error;
use crate::pictures::lettering::fitting;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use svg_pictures::SvgCanvas;

/// A field between axes. Its coordinates are places, from 0 to 1 along both.
pub(crate) type Chart<'a> = ChartContext<'a, SvgCanvas, Cartesian2d<Scale, Scale>>;

/// The size of the text, 8 pt, in units of 0.01 mm.
pub(crate) const TEXT: f64 = 282.0;
/// The length of ticks. Labels are twice as far from the axis.
const TICK: i32 = 90;

/// The width of rules.
pub(crate) fn rule() -> ShapeStyle {
    BLACK.stroke_width(14)
}

/// Returns the room below an axis for its labels and its title, with text of this size.
pub(crate) fn below(size: f64) -> i32 {
    2 * TICK + (2.0 * LINE * size) as i32
}

/// Returns the room beside an axis for its labels and its title, with text of this size.
pub(crate) fn beside(ordinate: &Scale, size: f64) -> i32 {
    let title = if ordinate.title.is_empty() { 0 } else { EDGE / 2 + (LINE * size) as i32 };
    2 * TICK + (ordinate.label_width() * size) as i32 + title
}

/// Draws the axes with their ticks, labels and titles in text of this size where they have room, the edge of the field, and
/// lines at the ticks if there is a grid.
///
/// # Errors
/// If a title cannot be drawn.
pub(crate) fn draw_axes(chart: &mut Chart<'_>, size: f64, has_grid: bool) -> Result<(), Error> {
    let (field, label) = (chart.plotting_area(), text(size, HPos::Center, VPos::Center));
    let (x, y) = (field.as_coord_spec().x_spec(), field.as_coord_spec().y_spec());
    let titles = [x.title.clone(), y.title.clone()];
    let lengths: [u32; 2] = field.dim_in_pixel().into();
    for (axis, (title, length)) in titles.into_iter().zip(lengths).enumerate() {
        let style = text(fitting(&title, size, f64::from(length)), HPos::Center, VPos::Center);
        let mut mesh = chart.configure_mesh();
        match axis {
            0 => mesh.disable_y_mesh().disable_y_axis().x_desc(title),
            _ => mesh.disable_x_mesh().disable_x_axis().y_desc(title),
        };
        if !has_grid {
            mesh.disable_mesh();
        }
        mesh.bold_line_style(RGBColor(225, 225, 225).stroke_width(14))
            .axis_style(rule())
            .set_all_tick_mark_size(TICK)
            .label_style(label.clone())
            .axis_desc_style(style)
            .draw()?;
    }
    chart.draw_series([Rectangle::new([(0.0, 0.0), (1.0, 1.0)], rule())])?;
    Ok(())
}
