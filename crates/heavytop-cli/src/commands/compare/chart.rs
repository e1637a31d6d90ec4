//! The chart of error against computing time, as SVG: the best methods in colour, with their names, and the others in grey.

use super::curve_labels::CurveLabels;
use super::logarithmic_axes::{Axes, SMALLEST, decades, scale};
use super::measurement::Measurement;
use super::ranking::best;
use crate::errors::Error;
use crate::pictures::Scale;
use crate::pictures::caption::{self, number};
use crate::pictures::charts::scaled_chart::{Chart, TEXT, below, beside, draw_axes};
use crate::pictures::charts::sheet::{Area, EDGE, Sheet, text};
use crate::pictures::curves::curve::STYLES;
use crate::pictures::lettering::width;
use crate::runs::{Experiment, TopInAxes};
use heavytop::methods::{Formulation, Method};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use svg_pictures::SvgElement;

/// The width and the height of the picture, in units of 0.01 mm.
const SIZE: [i32; 2] = [14_000, 11_000];

/// The number of methods in colour.
const BEST: usize = 5;

/// The colour of the other methods.
const OTHERS: RGBColor = RGBColor(205, 205, 205);

/// The radii of marks, and of those with the configured step.
const RADII: [i32; 2] = [55, 95];

/// The largest relative error that is drawn; runs with larger errors are no solutions.
const LARGEST: f64 = 1.0;

/// Draws the chart of the runs as SVG.
///
/// It leaves out a run that another step of the same method beats in both error and time. It rings the runs of the best
/// methods with the configured step.
///
/// # Errors
/// If a text cannot be drawn.
pub(super) fn chart(
    measurements: &[Measurement],
    experiment: &Experiment<TopInAxes>,
    end: f64,
) -> Result<String, Error> {
    let step = experiment.pace.schedule.step;
    let solutions = measurements.iter().filter(|m| m.outcome.relative <= LARGEST);
    let solutions: Vec<Measurement> = solutions.copied().collect();
    let curves = solutions.chunk_by(|one, other| one.method == other.method);
    let curves: Vec<Vec<Measurement>> = curves.map(unbeaten).collect();
    let outcomes = || curves.iter().flatten().map(|m| m.outcome);
    let axes = Axes {
        seconds: decades(outcomes().map(|o| o.seconds)),
        error: decades(outcomes().map(|o| o.relative.max(SMALLEST))),
    };
    let best = best(&solutions, BEST);
    let rank = |curve: &[Measurement]| {
        best.iter().position(|method| curve.first().is_some_and(|run| run.method == *method))
    };

    let sheet = Sheet::new(SIZE, &words(experiment, step), TEXT)?;
    let mut chart = panel(&sheet.body, &axes, end)?;
    for curve in curves.iter().filter(|curve| rank(curve).is_none()) {
        chart.draw_series([PathElement::new(places(&axes, curve), OTHERS.stroke_width(18))])?;
    }
    let mut coloured: Vec<(usize, &Vec<Measurement>)> =
        curves.iter().filter_map(|curve| Some((rank(curve)?, curve))).collect();
    coloured.sort_by_key(|(rank, _)| *rank);
    for (rank, curve) in &coloured {
        draw_curve(&mut chart, &axes, *rank, curve, step)?;
    }
    write_names(&chart, &axes, &coloured)?;
    Ok(sheet.drawing())
}

/// Returns the parts of the caption: the top, its start, and what is drawn.
fn words(experiment: &Experiment<TopInAxes>, step: f64) -> Vec<String> {
    vec![
        caption::top(&experiment.model.top),
        caption::start(&experiment.initial_state()),
        format!("a mark for each step, ringed {} s", number(step)),
        "grey: other methods".into(),
    ]
}

/// Creates the field with its axes.
fn panel(area: &Area, axes: &Axes, end: f64) -> Result<Chart<'static>, Error> {
    let error = format!(
        "relative error at <tspan font-style='italic'>t</tspan> = {} s: the larger of |δΠ| / max |Π| and \
         |δΓ| / max |Γ|",
        number(end)
    );
    let [_, height] = SIZE.map(f64::from);
    let abscissa = Scale {
        title: "computing time per simulated time".into(),
        ..scale(axes.seconds, every(axes.seconds, f64::from(SIZE[0]), 1500.0), |_| true)
    };
    let every = every(axes.error, height, 1000.0);
    let ordinate = Scale { title: error, ..scale(axes.error, every, |_| true) };
    let mut chart = ChartBuilder::on(area)
        .margin_left(EDGE)
        .margin_right(4 * EDGE)
        .margin_bottom(EDGE)
        .y_label_area_size(beside(&ordinate, TEXT))
        .x_label_area_size(below(TEXT))
        .build_cartesian_2d(abscissa, ordinate)?;
    draw_axes(&mut chart, TEXT, true)?;
    Ok(chart)
}

/// Returns the least n of which the multiples are apart on an axis with so many decades and labels of this size.
fn every((low, high): (i32, i32), length: f64, size: f64) -> i32 {
    (f64::from(high - low) * size / length).ceil().max(1.0) as i32
}

/// Returns the places of runs in the field.
fn places(axes: &Axes, runs: &[Measurement]) -> Vec<(f64, f64)> {
    runs.iter().map(|run| axes.place(run.outcome.seconds, run.outcome.relative)).collect()
}

/// Returns the runs that no other run beats in both error and time, the fastest first.
fn unbeaten(runs: &[Measurement]) -> Vec<Measurement> {
    let mut unbeaten = runs.to_vec();
    unbeaten.sort_by(|a, b| a.outcome.seconds.total_cmp(&b.outcome.seconds));
    let mut least = f64::INFINITY;
    unbeaten.retain(|run| {
        let better = run.outcome.relative < least;
        least = least.min(run.outcome.relative);
        better
    });
    unbeaten
}

/// Draws the runs of a method of this rank, joined by a line, each with its mark, and those with the configured step as
/// rings.
fn draw_curve(
    chart: &mut Chart<'_>,
    axes: &Axes,
    rank: usize,
    runs: &[Measurement],
    step: f64,
) -> Result<(), Error> {
    let Some(&(colour, dashes)) = STYLES.get(rank) else { return Ok(()) };
    let (places, line) = (places(axes, runs), colour.stroke_width(42));
    chart.draw_series([SvgElement::dashed(places.clone(), line, dashes)])?;
    for (run, place) in runs.iter().zip(places) {
        let is_configured = (run.step - step).abs() < 1e-6 * step.abs();
        let radius = RADII[usize::from(is_configured)];
        let fill = if is_configured { WHITE } else { colour };
        chart.draw_series([Circle::new(place, radius, fill.filled())])?;
        chart.draw_series([Circle::new(place, radius, line)])?;
    }
    Ok(())
}

/// Writes the names of the methods in colour beside their curves.
fn write_names(
    chart: &Chart<'_>,
    axes: &Axes,
    coloured: &[(usize, &Vec<Measurement>)],
) -> Result<(), Error> {
    let field = chart.plotting_area();
    let (origin, (across, down)) = (field.get_base_pixel(), field.dim_in_pixel());
    let at = |place: (f64, f64)| {
        let (x, y) = field.map_coordinate(&place);
        (f64::from(x - origin.0), f64::from(y - origin.1))
    };
    let curve = |(_, runs): &(usize, &Vec<Measurement>)| -> Vec<(f64, f64)> {
        places(axes, runs).into_iter().map(at).collect()
    };
    let curves: Vec<Vec<(f64, f64)>> = coloured.iter().map(curve).collect();
    let mut labels = CurveLabels::new((across.into(), down.into()), TEXT, &curves);
    let area = field.strip_coord_spec();
    for ((rank, runs), curve) in coloured.iter().zip(&curves) {
        let Some(name) = runs.first().map(|run| name(run.method)) else { continue };
        let (left, middle) = labels.place(curve, TEXT * width(&name));
        let colour = STYLES.get(*rank).map_or(BLACK, |style| style.0);
        let style = text(TEXT, HPos::Left, VPos::Center).color(&colour);
        area.draw_text(&name, &style, (left as i32, middle as i32))?;
    }
    Ok(())
}

/// Returns the name of a method, with what its steps are not.
fn name(method: Method) -> String {
    let (formulation, scheme) = (method.formulation(), method.scheme());
    let note = if formulation.is_poisson(scheme) { "" } else { ", not Poisson" };
    match formulation {
        Formulation::Splitting => format!("splitting {scheme}{note}"),
        _ => format!("{formulation} {scheme}{note}"),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::measurement::Outcome;
    use super::*;
    use crate::configuration::Config;
    use crate::pictures::lettering::checks::{collisions, texts};
    use heavytop::methods::{Formulation, Method, SchemeName};

    /// The chart of a top whose numbers and times are of this size.
    fn drawing(size: f64, time: f64) -> String {
        let text = format!(
            "body = {{ inertia = [{0:e}, {0:e}, {5:e}], mass = {1:e}, gravity = {2:e} }}\n\
             initial.angular_momentum = [{1:e}, 0, {1:e}]\n\
             integrator = {{ step = {3:e}, end = {4:e} }}",
            2.0 * size,
            size / time,
            1.0 / time,
            time / 50.0,
            time,
            size,
        );
        let config: Config = toml::from_str(&text).unwrap();
        let experiment = config.experiment().unwrap();
        let mut measurements = Vec::new();
        for &(_, formulation) in Formulation::NAMES {
            for scheme in formulation.schemes() {
                let method = Method::new(formulation, scheme, 0.0).unwrap();
                for (step, relative) in [(time / 50.0, 1e-3), (time / 500.0, 3e-14)] {
                    let (parts, deviations) = ([relative * size, relative], [0.0; 3]);
                    let seconds = 1e-6 / step;
                    let outcome = Outcome { error: relative, parts, relative, seconds, deviations };
                    measurements.push(Measurement { method, step, end: time, outcome });
                }
            }
        }
        chart(&measurements, &experiment, time).unwrap()
    }

    #[test]
    fn labels_are_apart_and_cut_at_no_scale() {
        for (size, time) in [(1e-20, 1.0), (2e-4, 1e-3), (1.0, 1.0), (1.0, 1e-9), (1e20, 1e5)] {
            let drawing = drawing(size, time);
            assert_eq!(collisions(&drawing, SIZE.map(f64::from).into()), [""; 0], "{size} {time}");
            let texts = texts(&drawing);
            let has = |part: &str| texts.iter().any(|text| text.contains(part));
            assert!(has("I = (") && has("Π(0) = (") && has("|δΠ| / max |Π|"), "{texts:?}");
            // There are labels on both axes.
            assert!(texts.iter().filter(|text| text.starts_with("10")).count() >= 6, "{texts:?}");
        }
    }

    /// The picture in the documents is that of its table.
    #[test]
    fn the_picture_of_the_documents_is_drawn_from_its_table() {
        let docs = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
        let Ok(table) = std::fs::read_to_string(docs.join("work-precision.csv")) else { return };
        let experiment = Config::default().experiment().unwrap();
        let measurements: Vec<Measurement> = table.lines().skip(1).map(read).collect();
        let end = measurements[0].end;
        let drawing = chart(&measurements, &experiment, end).unwrap();
        assert_eq!(collisions(&drawing, SIZE.map(f64::from).into()), [""; 0]);
        let texts = texts(&drawing);
        for formulation in ["collective", "reduced", "direct", "splitting"] {
            assert!(texts.iter().any(|text| text.starts_with(formulation)), "{texts:?}");
        }
        let (_, png) = crate::pictures::render::render(&drawing, 3.0).unwrap();
        let picture = docs.join("work-precision.png");
        if std::env::var_os("HEAVYTOP_DRAW_DOCUMENTS").is_some() {
            std::fs::write(&picture, &png).unwrap();
        }
        assert!(std::fs::read(&picture).unwrap() == png, "draw it with HEAVYTOP_DRAW_DOCUMENTS=1");
    }

    /// Reads a line of the table.
    fn read(line: &str) -> Measurement {
        let words: Vec<&str> = line.split(',').collect();
        let number = |column: usize| words[column].parse::<f64>().unwrap();
        let formulation = Formulation::NAMES.iter().find(|(name, _)| *name == words[0]).unwrap().1;
        let scheme = SchemeName::NAMES.iter().find(|(name, _)| *name == words[1]).unwrap().1;
        let outcome = Outcome {
            error: number(4),
            seconds: number(5),
            deviations: [6, 7, 8].map(number),
            parts: [9, 10].map(number),
            relative: number(11),
        };
        let method = Method::new(formulation, scheme, 0.0).unwrap();
        Measurement { method, step: number(2), end: number(3), outcome }
    }
}
