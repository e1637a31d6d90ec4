//! The picture of columns of a run against time, and of the deviations of its conserved quantities.

use super::deviation_curves::DeviationCurves;
use super::panel_plan::PanelPlan;
use super::plan_curves::{Curves, panel, read_against_time};
use super::time_axis::TimeAxis;
use crate::commands::plot::quantities::run_column::RunColumn;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::caption::{formula, plain};
use crate::pictures::curves::curve::STYLES;
use crate::pictures::curves::panels::{PANEL, Panels};
use crate::pictures::symbols::symbol;
use crate::pictures::{Axis, Scale};
use crate::runs::Experiment;

/// Draws the coordinates of a run and the columns that it was asked for against time, and below them how far the conserved
/// quantities are from their start.
///
/// # Errors
/// If the samples cannot be read.
pub(in crate::commands::plot) fn panels_picture(
    run: &RunArrays,
    experiment: &Experiment,
    all: &[RunColumn],
) -> Result<String, Error> {
    let groups = experiment.coordinates();
    let is_coordinate = |column: &&RunColumn| groups.iter().any(|(name, _)| *name == column.array);
    let coordinates: Vec<RunColumn> = all.iter().filter(is_coordinate).cloned().collect();
    let count = coordinates.len();
    let mut plans = PanelPlan::of_coordinates(coordinates);
    let drawn = plans.iter().map(|plan| plan.columns.len()).sum::<usize>();
    let requested = run.config.output.columns.iter().map(|one| one.name().replace('-', "_"));
    let requested: Vec<String> = requested.collect();
    let requested = all.iter().filter(|column| requested.contains(&column.array));
    plans.extend(PanelPlan::all(requested.cloned()));

    let mut conserved = experiment.conserved();
    conserved.retain(|name| run.has(name));
    let quantities = conserved.len();
    conserved.truncate(STYLES.len());
    let left_out = [(drawn, count, "coordinates"), (conserved.len(), quantities, "conserved")];
    let left_out = left_out.into_iter().filter(|(drawn, all, _)| drawn < all);
    let left_out = left_out.map(|(drawn, all, what)| format!("{drawn} of {all} {what}"));
    let caption = caption(run, experiment, &conserved).chain(left_out).collect::<Vec<_>>();
    let deviations = match run.times.len() > 1 {
        true => Some(DeviationCurves::read(run, &conserved)?),
        false => None,
    };
    draw(run, &plans, deviations, &caption)
}

/// Draws some columns of a run against time.
///
/// # Errors
/// If the samples cannot be read.
pub(in crate::commands::plot) fn columns_picture(
    run: &RunArrays,
    experiment: &Experiment,
    columns: Vec<RunColumn>,
) -> Result<String, Error> {
    let names: Vec<String> = columns.iter().map(|column| column.name.clone()).collect();
    let caption: Vec<String> = caption(run, experiment, &names).collect();
    draw(run, &PanelPlan::chosen(columns)?, None, &caption)
}

/// Returns the parts of a caption: what the run is of, and what those of the columns are that are Casimirs.
pub(super) fn caption(
    run: &RunArrays,
    experiment: &Experiment,
    columns: &[String],
) -> impl Iterator<Item = String> {
    let casimirs = columns.iter().filter(|name| *name != "h").filter_map(|name| {
        let function = experiment.model.formula(name)?;
        Some(format!("{} = {}", symbol(name), formula(function)))
    });
    run.subject.caption(&run.config).into_iter().chain(casimirs)
}

fn draw(
    run: &RunArrays,
    plans: &[PanelPlan],
    deviations: Option<DeviationCurves>,
    caption: &[String],
) -> Result<String, Error> {
    let time = TimeAxis::new(&run.times);
    let mut drawn: Vec<(Scale, Curves)> = Vec::new();
    for plan in plans {
        let curves = read_against_time(run, plan)?;
        let axis = Axis::around(curves.iter().flat_map(|(_, points)| points).map(|p| p.1), 4);
        let curves = curves.into_iter();
        let curves = curves.map(|(name, points)| (name, time.places(points, |x| axis.along(x))));
        drawn.push((Scale::linear(&axis, &plan.title(), false), curves.collect()));
    }
    if let Some(deviations) = deviations.filter(|deviations| !deviations.curves.is_empty()) {
        let ([least, most], scale) = (deviations.ends(), deviations.scale());
        let curves = deviations.curves.into_iter().map(|(name, points)| {
            (plain(&name), time.places(points, |value| (value - least) / (most - least)))
        });
        drawn.push((scale, curves.collect()));
    }
    let panels = Panels::new(caption, drawn.iter().map(panel).collect(), PANEL)?;
    panels.draw(&time.scale(panels.length()))
}
