//! The chart, as SVG: a panel for each formulation, all with the same axes.

use super::logarithmic_axes::{Axes, PANEL, SMALLEST, decades};
use super::measurement::Measurement;
use super::style::Style;
use crate::pictures::caption::{self, number};
use crate::pictures::lettering::{FONT, fitting, width};
use crate::pictures::numerals::power_of_ten;
use crate::runs::{Experiment, TopInAxes};
use heavytop::methods::{Formulation, SchemeName};
use std::fmt::Write;

/// The width of two columns of a journal, in units of 0.01 mm.
const WIDTH: f64 = 17_000.0;
const HEIGHT: f64 = 14_700.0;

/// The size of the text, 7 pt.
const TEXT: f64 = 247.0;
/// The upper left corners of the panels.
const CORNERS: [(f64, f64); 4] =
    [(1300.0, 1200.0), (7350.0, 1200.0), (1300.0, 7700.0), (7350.0, 7700.0)];
const LEGEND: (f64, f64) = (13_400.0, 1400.0);
const ROW: f64 = 400.0;

/// The largest relative error that is drawn; runs with larger errors are no solutions.
const LARGEST: f64 = 1.0;

/// Draws the chart of the runs as SVG.
///
/// It leaves out a run that another step of the same method beats in both error and time. It rings the runs with the
/// configured step.
pub(super) fn chart(
    measurements: &[Measurement],
    experiment: &Experiment<TopInAxes>,
    end: f64,
) -> String {
    let step = experiment.pace.schedule.step;
    let solutions = measurements.iter().filter(|m| m.outcome.relative <= LARGEST);
    let solutions: Vec<Measurement> = solutions.copied().collect();
    let curves = solutions.chunk_by(|one, other| one.method == other.method);
    let drawn: Vec<Measurement> = curves.flat_map(unbeaten).collect();
    let outcomes = || drawn.iter().map(|m| m.outcome);
    let seconds = decades(outcomes().map(|o| o.seconds));
    let error = decades(outcomes().map(|o| o.relative.max(SMALLEST)));

    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" \
         viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"{FONT}\" font-size=\"{TEXT}\" \
         stroke-linejoin=\"round\"><rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>",
        WIDTH / 100.0,
        HEIGHT / 100.0
    );
    for (&(_, formulation), corner) in Formulation::NAMES.iter().zip(CORNERS) {
        let axes = Axes { seconds, error, corner };
        frame(&mut svg, &axes, title(formulation));
        front(&mut svg, &axes, &drawn);
        for scheme in formulation.schemes() {
            let of_curve = |m: &&Measurement| {
                m.method.formulation() == formulation && m.method.scheme() == scheme
            };
            let runs: Vec<Measurement> = drawn.iter().filter(of_curve).copied().collect();
            curve(&mut svg, &axes, Style::of(scheme), &runs, step);
        }
    }
    titles(&mut svg, experiment, end);
    legend(&mut svg, measurements, step);
    svg + "</svg>"
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

// Writing to a string does not fail.

fn frame(svg: &mut String, axes: &Axes, title: &str) {
    let ((left, top), (width_of_panel, height)) = (axes.corner, PANEL);
    let (right, bottom) = (left + width_of_panel, top + height);
    let (middle, above) = (left + width_of_panel / 2.0, top - 130.0);
    let _ = write!(svg, "<text x=\"{middle}\" y=\"{above}\" text-anchor=\"middle\">{title}</text>");
    let _ = write!(svg, "<g stroke=\"#e1e1e1\" stroke-width=\"14\">");
    let mut labels = String::new();
    let (at_left, at_bottom) = (left == CORNERS[2].0, top == CORNERS[2].1);
    let most = |(low, high): (i32, i32)| {
        1.3 * TEXT * width(&power_of_ten(low)).max(width(&power_of_ten(high)))
    };
    let seconds = every(axes.seconds, width_of_panel, most(axes.seconds));
    for decade in axes.seconds.0..=axes.seconds.1 {
        let (x, y) = (axes.x(10_f64.powi(decade)), bottom + 380.0);
        let _ = write!(svg, "<path d=\"M{x:.0} {top}V{bottom}\"/>");
        // Neighbours share their axes, and the last label would be under the next panel's first.
        let shown = at_bottom && decade % seconds == 0 && (decade < axes.seconds.1 || !at_left);
        let power = if shown { power_of_ten(decade) } else { String::new() };
        let _ =
            write!(labels, "<text x=\"{x:.0}\" y=\"{y}\" text-anchor=\"middle\">{power}</text>");
    }
    let errors = every(axes.error, height, 1000.0);
    for decade in (axes.error.0..=axes.error.1).filter(|decade| decade % errors == 0) {
        let (x, y) = (left - 110.0, axes.y(10_f64.powi(decade)));
        let _ = write!(svg, "<path d=\"M{left} {y:.0}H{right}\"/>");
        let (base, power) = (y + 90.0, if at_left { power_of_ten(decade) } else { String::new() });
        let _ =
            write!(labels, "<text x=\"{x}\" y=\"{base:.0}\" text-anchor=\"end\">{power}</text>");
    }
    let _ = write!(
        svg,
        "</g>{labels}<rect x=\"{left}\" y=\"{top}\" width=\"{width_of_panel}\" height=\"{height}\" \
         fill=\"none\" stroke=\"black\" stroke-width=\"14\"/>"
    );
}

/// Draws the runs of all formulations that no other run beats.
fn front(svg: &mut String, axes: &Axes, drawn: &[Measurement]) {
    let outcomes = unbeaten(drawn).into_iter().map(|run| run.outcome);
    let points: String =
        outcomes.map(|o| format!("{:.0},{:.0} ", axes.x(o.seconds), axes.y(o.relative))).collect();
    let _ = write!(
        svg,
        "<polyline points=\"{points}\" fill=\"none\" stroke=\"#c8c8c8\" stroke-width=\"150\" \
         stroke-linecap=\"round\"/>"
    );
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

fn curve(svg: &mut String, axes: &Axes, style: Style, runs: &[Measurement], step: f64) {
    let Style { colour, dashes, mark } = style;
    let (mut points, mut marks) = (String::new(), String::new());
    for run in runs {
        let (x, y) = (axes.x(run.outcome.seconds), axes.y(run.outcome.relative));
        let _ = write!(points, "{x:.0},{y:.0} ");
        let configured = (run.step - step).abs() < 1e-6 * step.abs();
        let (radius, fill) = if configured { (75.0, "white") } else { (38.0, colour) };
        let _ = write!(marks, "<path d=\"{}\" fill=\"{fill}\"/>", mark.path(x, y, radius));
    }
    let dashes = if dashes.is_empty() { "none" } else { dashes };
    let _ = write!(
        svg,
        "<g stroke=\"{colour}\" stroke-width=\"28\"><polyline points=\"{points}\" fill=\"none\" \
         stroke-dasharray=\"{dashes}\"/>{marks}</g>"
    );
}

fn titles(svg: &mut String, experiment: &Experiment<TopInAxes>, end: f64) {
    let (x, y) = (CORNERS[1].0 - 150.0, HEIGHT - 250.0);
    let middle = CORNERS[1].1 / 2.0 + HEIGHT / 2.0;
    let error = format!(
        "relative error at <tspan font-style='italic'>t</tspan> = {} s: the larger of |δΠ| / max |Π| and \
         |δΓ| / max |Γ|",
        number(end)
    );
    let size = fitting(&error, TEXT, HEIGHT - CORNERS[1].1 - 500.0);
    let _ = write!(
        svg,
        "<g text-anchor=\"middle\"><text x=\"{x}\" y=\"{y}\">computing time per simulated time</text>\
         <text transform=\"translate(320 {middle}) rotate(-90)\" font-size=\"{size:.0}\">{error}</text>"
    );
    let words = format!(
        "{}; {}",
        caption::top(&experiment.model.top),
        caption::start(&experiment.initial_state())
    );
    let size = fitting(&words, TEXT, WIDTH - 600.0);
    let _ = write!(
        svg,
        "<text x=\"{}\" y=\"450\" font-size=\"{size:.0}\">{words}</text></g>",
        WIDTH / 2.0
    );
}

fn legend(svg: &mut String, measurements: &[Measurement], step: f64) {
    let (left, mut y) = LEGEND;
    let (right, text) = (left + 700.0, left + 850.0);
    for &(name, scheme) in SchemeName::NAMES {
        if !measurements.iter().any(|m| m.method.scheme() == scheme) {
            continue;
        }
        let Style { colour, dashes, mark } = Style::of(scheme);
        let (base, dashes) = (y + 88.0, if dashes.is_empty() { "none" } else { dashes });
        let mark = mark.path(left + 350.0, y, 60.0);
        let _ = write!(
            svg,
            "<path d=\"M{left} {y}H{right}\" stroke=\"{colour}\" stroke-width=\"42\" \
             stroke-dasharray=\"{dashes}\"/><path d=\"{mark}\" fill=\"{colour}\"/>\
             <text x=\"{text}\" y=\"{base}\">{name}</text>"
        );
        y += ROW;
    }
    let _ = write!(
        svg,
        "<path d=\"M{left} {y}H{right}\" stroke=\"#c8c8c8\" stroke-width=\"150\"/>\
         <text x=\"{text}\" y=\"{}\">best of all panels</text>",
        y + 88.0
    );
    y += ROW;
    let (centre, base) = (left + 350.0, y + 88.0);
    let step = format!("step {} s", number(step));
    let size = fitting(&step, TEXT, WIDTH - text - 100.0);
    let _ = write!(
        svg,
        "<circle cx=\"{centre}\" cy=\"{y}\" r=\"75\" fill=\"white\" stroke=\"black\" \
         stroke-width=\"28\"/><text x=\"{text}\" y=\"{base}\" font-size=\"{size:.0}\">{step}</text>\
         <text x=\"{text}\" y=\"{}\">others ×1.78 apart</text>",
        base + ROW
    );
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
        chart(&measurements, &experiment, time)
    }

    #[test]
    fn labels_are_apart_and_cut_at_no_scale() {
        for (size, time) in [(1e-20, 1.0), (2e-4, 1e-3), (1.0, 1.0), (1.0, 1e-9), (1e20, 1e5)] {
            let drawing = drawing(size, time);
            assert_eq!(collisions(&drawing, (WIDTH, HEIGHT)), [""; 0], "{size} {time}");
            let texts = texts(&drawing);
            let has = |part: &str| texts.iter().any(|text| text.contains(part));
            assert!(has("I = (") && has("Π(0) = (") && has("|δΠ| / max |Π|"), "{texts:?}");
            // The panels have labels on both axes.
            assert!(texts.iter().filter(|text| text.starts_with("10")).count() >= 6, "{texts:?}");
        }
    }
}
