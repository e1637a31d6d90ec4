//! The picture of columns of a run against another one: a projection of the orbit.

use super::panel_plan::PanelPlan;
use super::panels_picture::caption;
use super::plan_curves::{Curves, panel};
use crate::commands::plot::quantities::run_column::RunColumn;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::curves::panels::Panels;
use crate::pictures::{Axis, Scale};
use crate::runs::Experiment;

/// The largest number of points of a curve.
const MOST_POINTS: usize = 20_000;

/// The height of a single panel, in units of 0.01 mm, and of each of several.
const HEIGHTS: [i32; 2] = [8000, 4000];

/// Draws some columns of a run against another one, in a panel for each array or unit.
///
/// # Errors
/// If the samples cannot be read.
pub(in crate::commands::plot) fn phase_portrait(
    run: &RunArrays,
    experiment: &Experiment,
    columns: Vec<RunColumn>,
    abscissa: &RunColumn,
) -> Result<String, Error> {
    let stride = run.times.len().div_ceil(MOST_POINTS).max(1);
    let named = columns.iter().chain([abscissa]).map(|column| column.name.clone());
    let named: Vec<String> = named.collect();
    let thinned = (stride > 1).then(|| format!("every {stride} samples one is drawn"));
    let caption: Vec<String> = caption(run, experiment, &named).chain(thinned).collect();
    let plans = PanelPlan::chosen(columns)?;
    let height = HEIGHTS[usize::from(plans.len() > 1)];

    let mut drawn: Vec<(Scale, Curves)> = Vec::new();
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for plan in plans {
        let curves = read(run, &plan, abscissa, stride)?;
        let points = || curves.iter().flat_map(|(_, points)| points);
        let along = Axis::around(points().map(|point| point.0), 5);
        let upward = Axis::around(points().map(|point| point.1), 4);
        range = points().fold(range, |[least, most], (x, _)| [least.min(*x), most.max(*x)]);
        let place = |(x, y): (f64, f64)| (along.along(x), upward.along(y));
        let curves = curves.into_iter();
        let curves = curves.map(|(name, points)| (name, points.into_iter().map(place).collect()));
        drawn.push((Scale::linear(&upward, &plan.title(), false), curves.collect()));
    }
    let panels = Panels::new(&caption, drawn.iter().map(panel).collect(), height)?;
    let axis = Axis::around_along_line(range.into_iter(), 5, panels.length());
    panels.draw(&Scale::linear(&axis, &abscissa.with_unit(&abscissa.symbol), false))
}

/// Reads the curves of a panel from every n-th sample. An angle that jumps by 2π has a gap there.
pub(in crate::commands::plot) fn read(
    run: &RunArrays,
    plan: &PanelPlan,
    abscissa: &RunColumn,
    stride: usize,
) -> Result<Curves, Error> {
    let mut with_abscissa = plan.clone();
    with_abscissa.columns.push(abscissa.clone());
    let arrays = with_abscissa.arrays();
    let mut places = with_abscissa.places(&arrays);
    let along = places.pop().unwrap_or_default();
    let mut curves = vec![Vec::new(); places.len()];
    let mut last: Option<Vec<f64>> = None;
    let end = run.times.len().saturating_sub(1);
    run.each(&arrays, |number, values| {
        if number.is_multiple_of(stride) || number == end {
            let value = |place: usize| values.get(place).copied().unwrap_or(f64::NAN);
            for ((curve, place), column) in curves.iter_mut().zip(&places).zip(&plan.columns) {
                let jumps = last.as_ref().is_some_and(|last| {
                    [(column, *place), (abscissa, along)].into_iter().any(|(column, place)| {
                        let before = last.get(place).copied().unwrap_or(f64::NAN);
                        column.is_periodic() && (value(place) - before).abs() > std::f64::consts::PI
                    })
                });
                if jumps {
                    curve.push((f64::NAN, f64::NAN));
                }
                curve.push((value(along), value(*place)));
            }
            last = Some(values.to_vec());
        }
        Ok(true)
    })?;
    let names = plan.columns.iter().map(|column| column.symbol.clone());
    Ok(names.zip(curves).collect())
}
