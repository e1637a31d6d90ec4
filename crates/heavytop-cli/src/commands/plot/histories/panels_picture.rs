//! The picture of the coordinates of a run against time, and of the deviations of its conserved quantities.

use super::deviation_curves::DeviationCurves;
use super::panel_plan::PanelPlan;
use super::thinned::Thinned;
use super::time_axis::TimeAxis;
use super::top_words;
use crate::commands::plot::run_arrays::RunArrays;
use crate::commands::plot::run_subject::RunSubject;
use crate::errors::Error;
use crate::pictures::caption::plain;
use crate::pictures::curves::curve::{Curve, STYLES};
use crate::pictures::curves::panels::{Panel, Panels};
use crate::pictures::{Axis, Scale};
use crate::runs::Experiment;
use crate::vocabulary::brief;
use plotters::style::RGBColor;

/// The curves of a panel: their names, and the points.
type Curves = Vec<(String, Vec<(f64, f64)>)>;

/// Draws the coordinates of a run against time, and below them how far the conserved quantities are from their start.
///
/// # Errors
/// If the samples cannot be read.
pub(in crate::commands::plot) fn panels_picture(run: &RunArrays) -> Result<String, Error> {
    let RunSubject::Coordinates { run: experiment, .. } = &run.subject else {
        return Err(Error::Figure("the arrays of the run are no coordinates".into()));
    };
    let is_top = run.config.system.is_none();
    let plans = PanelPlan::all(experiment.coordinates());
    let mut ordinates = Vec::new();
    for plan in &plans {
        let curves = read(run, plan)?;
        let axis = Axis::around(curves.iter().flat_map(|(_, points)| points).map(|p| p.1), 4);
        ordinates.push((axis, plan.title(), curves));
    }
    let mut conserved = experiment.conserved();
    conserved.retain(|name| run.has(name));
    let all = conserved.len();
    conserved.truncate(STYLES.len());
    let deviations = match run.times.len() > 1 {
        true => DeviationCurves::read(run, &conserved)?,
        false => DeviationCurves::default(),
    };

    let time = TimeAxis::new(&run.times);
    let mut drawn: Vec<(Scale, Curves)> = Vec::new();
    for (axis, title, curves) in ordinates {
        let title = if is_top { top_words::title(&title) } else { plain(&title) };
        let curves = curves.into_iter().map(|(name, points)| {
            let name = if is_top { top_words::symbol(&name) } else { name };
            (name, time.places(points, |value| axis.along(value)))
        });
        drawn.push((Scale::linear(&axis, &title, false), curves.collect()));
    }
    if !deviations.curves.is_empty() {
        let ([least, most], scale) = (deviations.ends(), deviations.scale());
        let curves = deviations.curves.into_iter().map(|(name, points)| {
            (name, time.places(points, |value| (value - least) / (most - least)))
        });
        drawn.push((scale, curves.collect()));
    }
    let panels = drawn.iter().map(|(ordinate, curves)| Panel {
        ordinate: ordinate.clone(),
        curves: curves.iter().zip(STYLES).map(|(curve, style)| styled(curve, style)).collect(),
    });
    let caption = caption(run, experiment, &plans, (&conserved, all));
    let panels = Panels::new(&caption, panels.collect())?;
    panels.draw(&time.scale(panels.length()))
}

/// Reads the curves of a panel.
fn read(run: &RunArrays, plan: &PanelPlan) -> Result<Curves, Error> {
    let mut curves = vec![Thinned::new(run.times.len()); plan.columns.len()];
    run.each(&plan.arrays, |number, values| {
        for (curve, value) in curves.iter_mut().zip(values) {
            curve.push(run.time(number), *value);
        }
        Ok(true)
    })?;
    let curves = curves.into_iter().map(Thinned::complete);
    Ok(plan.columns.iter().cloned().zip(curves).collect())
}

fn styled<'a>(
    (name, points): &'a (String, Vec<(f64, f64)>),
    (colour, dashes): (RGBColor, &'static str),
) -> Curve<'a> {
    Curve { name: plain(name), colour, dashes, points }
}

/// Returns the parts of the caption. It says what is left out, and what the Casimirs are.
fn caption(
    run: &RunArrays,
    experiment: &Experiment,
    plans: &[PanelPlan],
    (conserved, all): (&[String], usize),
) -> Vec<String> {
    let casimirs = conserved.iter().filter(|name| *name != "h").filter_map(|name| {
        let formula = brief::text(&experiment.model.formula(name)?);
        Some(format!("{name} = {}", plain(&formula)))
    });
    let (drawn, coordinates) = (
        plans.iter().map(|plan| plan.columns.len()).sum::<usize>(),
        experiment.coordinates().iter().map(|(_, columns)| columns.len()).sum::<usize>(),
    );
    let left_out = [(drawn, coordinates, "coordinates"), (conserved.len(), all, "conserved")];
    let left_out = left_out.into_iter().filter(|(drawn, all, _)| drawn < all);
    let left_out = left_out.map(|(drawn, all, what)| format!("{drawn} of {all} {what}"));
    let words = run.subject.caption(&run.config).into_iter();
    words.chain(casimirs).chain(left_out).collect()
}
