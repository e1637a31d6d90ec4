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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::pictures::charts::frame::WIDTH;
    use crate::pictures::lettering::checks::{collisions, texts};

    /// The curve of an observable of five tops whose sizes are all of this size.
    fn curve(size: f64, observable: &str, values: [Option<f64>; 5]) -> String {
        let text = format!(
            "body = {{ inertia = [{0:e}, {1:e}, {size:e}], mass = {size:e}, gravity = 1.0 }}\n\
             sweep.observables = ['{observable}']\n\
             [[sweep.axes]]\nparameter = 'body.inertia[1]'\nfrom = {1:e}\nto = {0:e}\ncount = 5",
            2.0 * size,
            2.5 * size,
        );
        let plan = Plan::new(&toml::from_str(&text).unwrap()).unwrap();
        let failed = values.iter().filter(|value| value.is_none()).count() as u64;
        member_curve(&plan, &plan.columns[0], &values, failed).unwrap()
    }

    const VALUES: [f64; 5] = [0.1, 0.2, -0.7, 0.4, 0.5];

    #[test]
    fn labels_are_apart_and_cut_at_no_scale() {
        for size in [1e-30, 2e-4, 1.0, 1e30] {
            for observable in ["final-state", "megno", "invariant-drift"] {
                for values in [
                    VALUES.map(|x| Some(x * size)),
                    [Some(size); 5],
                    [Some(0.0); 5],
                    [Some(size), None, Some(2.0 * size), None, None],
                    [None; 5],
                ] {
                    let drawing = curve(size, observable, values);
                    let found = collisions(&drawing, (WIDTH.into(), HEIGHT.into()));
                    assert_eq!(found, [""; 0], "{size} {observable} {:?}", texts(&drawing));
                    assert!(!drawing.contains("NaN"), "{size} {observable}");
                }
            }
        }
    }

    /// The heights of the points of a curve, from its lowest to its highest, depend on no unit. They are whole numbers of some
    /// thousands.
    #[test]
    fn a_curve_looks_the_same_in_all_units() {
        let heights = |size: f64, factor: f64| {
            let drawing = curve(size, "final-state", VALUES.map(|x| Some(factor * x * size)));
            let (_, marks) = drawing.rsplit_once("stroke-dasharray=\"none\"").unwrap();
            let path = marks.split("d=\"M").nth(1).unwrap().split('"').next().unwrap();
            let points = path.split('L').map(|point| point.split_once(' ').unwrap().1);
            let heights: Vec<f64> = points.map(|y| y.parse().unwrap()).collect();
            let most = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let least = heights.iter().copied().fold(f64::INFINITY, f64::min);
            heights.into_iter().map(move |y| (y - least) / (most - least)).collect::<Vec<_>>()
        };
        let are_near = |one: Vec<f64>, other: Vec<f64>| {
            one.iter().zip(other).all(|(one, other)| (one - other).abs() < 1e-3)
        };
        for size in [1e-30, 1e30] {
            assert!(are_near(heights(1.0, 1.0), heights(size, 1.0)), "{size}");
            // Control: other values have other heights.
            assert!(!are_near(heights(1.0, 1.0), heights(size, -1.0)), "{size}");
        }
    }
}
