//! The curve of an observable over the single axis of a sweep, as SVG.

use super::colours::{bar_scale, ends, scaled};
use super::heat_map::is_reversed;
use super::words::{blank, words};
use crate::commands::sweep::sweep_plan::Plan;
use crate::configuration::Column;
use crate::errors::Error;
use crate::pictures::charts::frame::HEIGHT;
use crate::pictures::colour_scale::colour;
use crate::pictures::curves::curve::{BLUE, Curve, GRAY, WHOLE};
use crate::pictures::{Axis, Frame, Scale};
use plotters::prelude::*;
use svg_pictures::SvgElement;

/// The largest number of members that have dots on their curve.
const MOST_DOTS: u64 = 200;

/// The diameters of dots, and of those of random members, which have no curve, in units of 0.01 mm.
const DOTS: [f64; 2] = [80.0, 50.0];

/// Draws the values over the axis. A member without a value is a gap. Random members are dots.
///
/// `failed` is the number of members that could not be followed.
///
/// # Errors
/// If the picture cannot be drawn.
pub(super) fn member_curve(
    plan: &Plan,
    column: &Column,
    values: &[Option<f64>],
    failed: u64,
) -> Result<String, Error> {
    let labels = plan.family.labels();
    let ([axis], [label]) = (plan.axes.as_slice(), labels.as_slice()) else {
        return Err(Error::Figure("a curve needs a single axis".into()));
    };
    let (column, values) = &scaled(column, values);
    let missing = values.iter().filter(|value| value.is_none()).count();
    let run = |number| plan.family.run_values(&plan.parameters(number)).first().copied();
    let places: Vec<f64> =
        (0..plan.members).map(|number| run(number).unwrap_or(f64::NAN)).collect();
    let (is_grid, is_reversed) = (axis.is_grid(), is_reversed(axis));

    let range = ends(values, column);
    let ordinate = range.map_or_else(Scale::default, |range| bar_scale(column, range));
    let mut caption = words(plan);
    caption.extend((missing > 0).then(|| format!("no value: {missing}")));
    let frame = Frame::new(HEIGHT, &caption, ordinate.clone(), None)?;
    let [low, high] = places
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(*x), high.max(*x)]);
    let abscissa = match is_grid {
        true => Axis::along_line(low, high, 5, frame.length()),
        false => Axis::around_along_line([low, high].into_iter(), 5, frame.length()),
    };
    let mut chart = frame.chart(Scale::linear(&abscissa, label, is_reversed))?;
    let Some([least, most]) = range else {
        blank(&chart.plotting_area().strip_coord_spec(), column, (failed, plan))?;
        return frame.complete(chart, colour);
    };
    if let Some(along) = ordinate.line {
        let style = GRAY.stroke_width(14);
        chart.draw_series([PathElement::new([(0.0, along), (1.0, along)], style)])?;
    }
    let along = |x: f64| if is_reversed { 1.0 - abscissa.along(x) } else { abscissa.along(x) };
    let upward = |value: f64| (value / 2.0 - least / 2.0) / (most / 2.0 - least / 2.0);
    let points: Vec<(f64, f64)> = places
        .iter()
        .zip(values)
        .map(|(x, value)| (along(*x), value.map_or(f64::NAN, upward)))
        .collect();
    if is_grid {
        let curve = Curve { name: String::new(), colour: BLUE, dashes: WHOLE, points: &points };
        curve.draw(&mut chart, |place| place)?;
    }
    if !is_grid || plan.members <= MOST_DOTS {
        let points = points.iter().copied().filter(|point| point.1.is_finite());
        let diameter = DOTS[usize::from(!is_grid)];
        chart.draw_series([SvgElement::dots(points.collect::<Vec<_>>(), BLUE, diameter)])?;
    }
    frame.complete(chart, colour)
}
