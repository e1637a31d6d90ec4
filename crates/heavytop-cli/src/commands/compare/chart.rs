//! The chart, as SVG: a panel for each formulation, all with the same axes.

use super::logarithmic_axes::{Axes, SMALLEST, decades, scale};
use super::measurement::Measurement;
use super::style::Style;
use crate::errors::Error;
use crate::pictures::caption::{self, number};
use crate::pictures::charts::scaled_chart::{Chart, draw_axes};
use crate::pictures::charts::sheet::{Area, EDGE, Sheet, text};
use crate::pictures::lettering::{fitting, width};
use crate::pictures::numerals::power_of_ten;
use crate::runs::{Experiment, TopInAxes};
use heavytop::methods::{Formulation, SchemeName};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use svg_pictures::SvgElement;

/// The width of two columns of a journal, in units of 0.01 mm.
const WIDTH: i32 = 17_000;
const HEIGHT: i32 = 14_700;

/// The size of the text, 7 pt.
const TEXT: f64 = 247.0;
/// The upper left corners of the panels below the caption, their width and height, and the room for labels around them.
const CORNERS: [(i32, i32); 4] = [(1300, 600), (7350, 600), (1300, 7100), (7350, 7100)];
const PANEL: (i32, i32) = (5700, 5900);
const LABELS: i32 = 700;
/// The place of the legend, the length of its lines, and the height of its rows.
const LEGEND: (i32, i32) = (13_400, 800);
const LINE: i32 = 700;
const ROW: i32 = 400;

/// The colour of the runs that no other run beats.
const FRONT: RGBColor = RGBColor(200, 200, 200);

/// The largest relative error that is drawn; runs with larger errors are no solutions.
const LARGEST: f64 = 1.0;

/// Draws the chart of the runs as SVG.
///
/// It leaves out a run that another step of the same method beats in both error and time. It rings the runs with the
/// configured step.
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
    let drawn: Vec<Measurement> = curves.flat_map(unbeaten).collect();
    let outcomes = || drawn.iter().map(|m| m.outcome);
    let seconds = decades(outcomes().map(|o| o.seconds));
    let error = decades(outcomes().map(|o| o.relative.max(SMALLEST)));
    let axes = Axes { seconds, error };

    let words = format!(
        "{}; {}",
        caption::top(&experiment.model.top),
        caption::start(&experiment.initial_state())
    );
    let sheet = Sheet::new([WIDTH, HEIGHT], &[words], TEXT)?;
    for (&(_, formulation), corner) in Formulation::NAMES.iter().zip(CORNERS) {
        let mut chart = panel(&sheet.body, &axes, corner, title(formulation))?;
        let front = places(&axes, &unbeaten(&drawn));
        chart.draw_series([PathElement::new(front, FRONT.stroke_width(150))])?;
        for scheme in formulation.schemes() {
            let of_curve = |m: &&Measurement| {
                m.method.formulation() == formulation && m.method.scheme() == scheme
            };
            let runs: Vec<Measurement> = drawn.iter().filter(of_curve).copied().collect();
            draw_curve(&mut chart, &axes, Style::of(scheme), &runs, step)?;
        }
    }
    titles(&sheet.body, end)?;
    legend(&sheet.body, measurements, step)?;
    Ok(sheet.drawing())
}

fn title(formulation: Formulation) -> &'static str {
    match formulation {
        Formulation::Collective => "collective, on T∗C²",
        Formulation::Reduced => "reduced, without a lift",
        Formulation::Direct => "direct, not Poisson",
        Formulation::Splitting => "splitting, explicit",
    }
}

/// Returns the least n of which the multiples are apart on an axis with so many decades and labels of this size.
fn every((low, high): (i32, i32), length: f64, size: f64) -> i32 {
    (f64::from(high - low) * size / length).ceil().max(1.0) as i32
}

/// Creates a panel with its axes, and its title above it.
fn panel(
    area: &Area,
    axes: &Axes,
    (left, top): (i32, i32),
    title: &str,
) -> Result<Chart<'static>, Error> {
    let ((width_of_panel, height), (_, below)) = (PANEL, area.dim_in_pixel());
    let (at_left, at_bottom) = (left == CORNERS[2].0, top == CORNERS[2].1);
    let most = |(low, high): (i32, i32)| {
        1.3 * TEXT * width(&power_of_ten(low)).max(width(&power_of_ten(high)))
    };
    let seconds = every(axes.seconds, width_of_panel.into(), most(axes.seconds));
    // Neighbours share their axes, and the last label would be under the next panel's first.
    let is_labelled =
        |decade| at_bottom && decade % seconds == 0 && (decade < axes.seconds.1 || !at_left);
    let abscissa = scale(axes.seconds, 1, is_labelled);
    let ordinate = scale(axes.error, every(axes.error, height.into(), 1000.0), |_| at_left);
    let mut chart = ChartBuilder::on(area)
        .margin_left(left - LABELS)
        .margin_top(top)
        .margin_right(WIDTH - left - width_of_panel)
        .margin_bottom(below as i32 - top - height - LABELS)
        .y_label_area_size(LABELS)
        .x_label_area_size(LABELS)
        .build_cartesian_2d(abscissa, ordinate)?;
    draw_axes(&mut chart, TEXT, true)?;
    let style = text(TEXT, HPos::Center, VPos::Bottom);
    area.draw_text(title, &style, (left + width_of_panel / 2, top - EDGE / 2))?;
    Ok(chart)
}

/// Returns the places of runs in a panel.
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

/// Draws the runs of a method, joined by a line, each with its mark, and those with the configured step as rings.
fn draw_curve(
    chart: &mut Chart<'_>,
    axes: &Axes,
    style: Style,
    runs: &[Measurement],
    step: f64,
) -> Result<(), Error> {
    let Style { colour, dashes, mark } = style;
    let (places, line) = (places(axes, runs), colour.stroke_width(28));
    chart.draw_series([SvgElement::dashed(places.clone(), line, dashes)])?;
    let field = chart.plotting_area();
    let (whole, (x, y)) = (field.strip_coord_spec(), field.get_base_pixel());
    for (run, place) in runs.iter().zip(&places) {
        let configured = (run.step - step).abs() < 1e-6 * step.abs();
        let (radius, fill) = if configured { (75.0, WHITE) } else { (38.0, colour) };
        let at = field.map_coordinate(place);
        draw_mark(&whole, mark.corners((at.0 - x, at.1 - y), radius), fill, line)?;
    }
    Ok(())
}

/// Draws a mark with these corners.
fn draw_mark(
    area: &Area,
    mut corners: Vec<(i32, i32)>,
    fill: RGBColor,
    line: ShapeStyle,
) -> Result<(), Error> {
    area.draw(&Polygon::new(corners.clone(), fill))?;
    corners.extend(corners.first().copied());
    area.draw(&PathElement::new(corners, line))?;
    Ok(())
}

/// Writes the titles of the axes, which all panels share.
fn titles(area: &Area, end: f64) -> Result<(), Error> {
    let ((left, top), height) = (CORNERS[1], area.dim_in_pixel().1 as i32);
    let style = text(TEXT, HPos::Center, VPos::Bottom);
    let place = (left - 150, height - EDGE);
    area.draw_text("computing time per simulated time", &style, place)?;
    let error = format!(
        "relative error at <tspan font-style='italic'>t</tspan> = {} s: the larger of |δΠ| / max |Π| and \
         |δΓ| / max |Γ|",
        number(end)
    );
    let size = fitting(&error, TEXT, f64::from(height - top - 500));
    let style = text(size, HPos::Center, VPos::Top).transform(FontTransform::Rotate270);
    area.draw_text(&error, &style, (EDGE, (top + height) / 2))?;
    Ok(())
}

/// Draws the lines and marks of the methods that were measured, and what else the panels show.
fn legend(area: &Area, measurements: &[Measurement], step: f64) -> Result<(), Error> {
    let (left, mut y) = LEGEND;
    let (middle, right) = (left + LINE / 2, left + LINE);
    let write = |label: &str, y: i32| {
        let room = f64::from(WIDTH - right - 150 - EDGE);
        let style = text(fitting(label, TEXT, room), HPos::Left, VPos::Center);
        area.draw_text(label, &style, (right + 150, y))
    };
    for &(name, scheme) in SchemeName::NAMES {
        if measurements.iter().any(|m| m.method.scheme() == scheme) {
            let Style { colour, dashes, mark } = Style::of(scheme);
            let line = [(left, y), (right, y)];
            area.draw(&SvgElement::dashed(line, colour.stroke_width(42), dashes))?;
            draw_mark(area, mark.corners((middle, y), 60.0), colour, colour.stroke_width(1))?;
            write(name, y)?;
            y += ROW;
        }
    }
    area.draw(&PathElement::new([(left, y), (right, y)], FRONT.stroke_width(150)))?;
    write("best of all panels", y)?;
    y += ROW;
    area.draw(&Circle::new((middle, y), 75, BLACK.stroke_width(28)))?;
    write(&format!("step {} s", number(step)), y)?;
    write("others ×1.78 apart", y + ROW)?;
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::measurement::Outcome;
    use super::*;
    use crate::configuration::Config;
    use crate::pictures::lettering::checks::{collisions, texts};
    use heavytop::methods::Method;

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
            assert_eq!(
                collisions(&drawing, (WIDTH.into(), HEIGHT.into())),
                [""; 0],
                "{size} {time}"
            );
            let texts = texts(&drawing);
            let has = |part: &str| texts.iter().any(|text| text.contains(part));
            assert!(has("I = (") && has("Π(0) = (") && has("|δΠ| / max |Π|"), "{texts:?}");
            // The panels have labels on both axes.
            assert!(texts.iter().filter(|text| text.starts_with("10")).count() >= 6, "{texts:?}");
        }
    }
}
