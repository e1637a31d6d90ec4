//! The curves of the columns of a panel.

use super::panel_plan::PanelPlan;
use super::thinned::Thinned;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::Scale;
use crate::pictures::curves::curve::{Curve, STYLES};
use crate::pictures::curves::panels::Panel;
use std::f64::consts::PI;

/// The curves of a panel: their names, as the inside of an SVG text, and the points.
pub(in crate::commands::plot) type Curves = Vec<(String, Vec<(f64, f64)>)>;

/// Reads the curves of a panel against time.
///
/// # Errors
/// If the samples cannot be read.
pub(in crate::commands::plot) fn read_against_time(
    run: &RunArrays,
    plan: &PanelPlan,
) -> Result<Curves, Error> {
    let mut curves = vec![Thinned::new(run.times.len()); plan.columns.len()];
    let arrays = plan.arrays();
    let places = plan.places(&arrays);
    run.each(&arrays, |number, values| {
        for (curve, place) in curves.iter_mut().zip(&places) {
            curve.push(run.time(number), values.get(*place).copied().unwrap_or(f64::NAN));
        }
        Ok(true)
    })?;
    let curves = plan.columns.iter().zip(curves).map(|(column, curve)| {
        let points = curve.complete();
        let points = if column.is_periodic() { broken(points) } else { points };
        (column.symbol.clone(), points)
    });
    Ok(curves.collect())
}

/// Breaks the curve of an angle where it jumps by 2π.
fn broken(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let mut pieces: Vec<(f64, f64)> = Vec::new();
    for point in points {
        if pieces.last().is_some_and(|last| (last.1 - point.1).abs() > PI) {
            pieces.push((point.0, f64::NAN));
        }
        pieces.push(point);
    }
    pieces
}

/// Returns the panel of some curves.
pub(super) fn panel((ordinate, curves): &(Scale, Curves)) -> Panel<'_> {
    let styled = curves.iter().zip(STYLES);
    let curves = styled.map(|((name, points), (colour, dashes))| Curve {
        name: name.clone(),
        colour,
        dashes,
        points,
    });
    Panel { ordinate: ordinate.clone(), curves: curves.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_is_broken_where_it_jumps_and_nowhere_else() {
        let angle = [2.0, 3.0, -3.1, -1.0, 2.0];
        let points = |angles: &[f64]| angles.iter().map(|angle| (0.0, *angle)).collect::<Vec<_>>();
        let found: Vec<String> =
            broken(points(&angle)).iter().map(|point| point.1.to_string()).collect();
        assert_eq!(found, ["2", "3", "NaN", "-3.1", "-1", "2"]);
        assert_eq!(broken(points(&angle[..2])), points(&angle[..2]));
    }
}
