//! The chart, as SVG: a panel for each formulation, all with the same axes.

use super::logarithmic_axes::{Axes, PANEL, SMALLEST, decades, power};
use super::measurement::Measurement;
use super::style::Style;
use crate::pictures::render::FONT;
use crate::vocabulary::{Formulation, Scheme};
use std::fmt::Write;

/// The width of two columns of a journal, in units of 0.01 mm.
const WIDTH: f64 = 17_000.0;
const HEIGHT: f64 = 14_000.0;

/// The size of the text, 7 pt.
const TEXT: f64 = 247.0;
/// The upper left corners of the panels.
const CORNERS: [(f64, f64); 4] =
    [(1300.0, 500.0), (7350.0, 500.0), (1300.0, 7000.0), (7350.0, 7000.0)];
const LEGEND: (f64, f64) = (13_400.0, 700.0);
const ROW: f64 = 400.0;

/// The largest error that is drawn; runs with larger errors are no solutions.
const LARGEST: f64 = 1.0;

/// Draws the chart of the runs as SVG.
///
/// It leaves out a run that another step of the same method beats in both error and time. It rings the runs with the
/// configured step.
pub(super) fn chart(measurements: &[Measurement], step: f64, end: f64) -> String {
    let solutions = measurements.iter().filter(|m| m.outcome.error <= LARGEST);
    let solutions: Vec<Measurement> = solutions.copied().collect();
    let curves = solutions.chunk_by(|one, other| one.method == other.method);
    let drawn: Vec<Measurement> = curves.flat_map(unbeaten).collect();
    let outcomes = || drawn.iter().map(|m| m.outcome);
    let seconds = decades(outcomes().map(|o| o.seconds));
    let error = decades(outcomes().map(|o| o.error.max(SMALLEST)));

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
    titles(&mut svg, end);
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

// Writing to a string does not fail.

fn frame(svg: &mut String, axes: &Axes, title: &str) {
    let ((left, top), (width, height)) = (axes.corner, PANEL);
    let (right, bottom) = (left + width, top + height);
    let (middle, above) = (left + width / 2.0, top - 130.0);
    let _ = write!(svg, "<text x=\"{middle}\" y=\"{above}\" text-anchor=\"middle\">{title}</text>");
    let _ = write!(svg, "<g stroke=\"#e1e1e1\" stroke-width=\"14\">");
    let mut labels = String::new();
    let (at_left, at_bottom) = (left == CORNERS[2].0, top == CORNERS[2].1);
    for decade in axes.seconds.0..=axes.seconds.1 {
        let (x, y) = (axes.x(10_f64.powi(decade)), bottom + 330.0);
        let _ = write!(svg, "<path d=\"M{x:.0} {top}V{bottom}\"/>");
        // Neighbours share their axes, and the last label would be under the next panel's first.
        let power = if at_bottom && (decade < axes.seconds.1 || !at_left) {
            power(decade)
        } else {
            String::new()
        };
        let _ =
            write!(labels, "<text x=\"{x:.0}\" y=\"{y}\" text-anchor=\"middle\">{power}</text>");
    }
    for decade in (axes.error.0..=axes.error.1).filter(|decade| decade % 3 == 0) {
        let (x, y) = (left - 110.0, axes.y(10_f64.powi(decade)));
        let _ = write!(svg, "<path d=\"M{left} {y:.0}H{right}\"/>");
        let (base, power) = (y + 90.0, if at_left { power(decade) } else { String::new() });
        let _ =
            write!(labels, "<text x=\"{x}\" y=\"{base:.0}\" text-anchor=\"end\">{power}</text>");
    }
    let _ = write!(
        svg,
        "</g>{labels}<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" \
         fill=\"none\" stroke=\"black\" stroke-width=\"14\"/>"
    );
}

/// Draws the runs of all formulations that no other run beats.
fn front(svg: &mut String, axes: &Axes, drawn: &[Measurement]) {
    let outcomes = unbeaten(drawn).into_iter().map(|run| run.outcome);
    let points: String =
        outcomes.map(|o| format!("{:.0},{:.0} ", axes.x(o.seconds), axes.y(o.error))).collect();
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
        let better = run.outcome.error < least;
        least = least.min(run.outcome.error);
        better
    });
    unbeaten
}

fn curve(svg: &mut String, axes: &Axes, style: Style, runs: &[Measurement], step: f64) {
    let Style { colour, dashes } = style;
    let (mut points, mut marks) = (String::new(), String::new());
    for run in runs {
        let (x, y) = (axes.x(run.outcome.seconds), axes.y(run.outcome.error));
        let _ = write!(points, "{x:.0},{y:.0} ");
        let configured = (run.step - step).abs() < 1e-6 * step;
        let (radius, fill) = if configured { (75, "white") } else { (38, colour) };
        let _ =
            write!(marks, "<circle cx=\"{x:.0}\" cy=\"{y:.0}\" r=\"{radius}\" fill=\"{fill}\"/>");
    }
    let dashes = if dashes.is_empty() { "none" } else { dashes };
    let _ = write!(
        svg,
        "<g stroke=\"{colour}\" stroke-width=\"28\"><polyline points=\"{points}\" fill=\"none\" \
         stroke-dasharray=\"{dashes}\"/>{marks}</g>"
    );
}

fn titles(svg: &mut String, end: f64) {
    let (x, y) = (CORNERS[1].0 - 150.0, HEIGHT - 250.0);
    let middle = HEIGHT / 2.0;
    let _ = write!(
        svg,
        "<g text-anchor=\"middle\"><text x=\"{x}\" y=\"{y}\">computing time per simulated time</text>\
         <text transform=\"translate(320 {middle}) rotate(-90)\">error of (Π, Γ) at \
         <tspan font-style='italic'>t</tspan> = {end} s, 2-norm</text></g>"
    );
}

fn legend(svg: &mut String, measurements: &[Measurement], step: f64) {
    let (left, mut y) = LEGEND;
    let (right, text) = (left + 700.0, left + 850.0);
    for &(name, scheme) in Scheme::NAMES {
        if !measurements.iter().any(|m| m.method.scheme() == scheme) {
            continue;
        }
        let Style { colour, dashes } = Style::of(scheme);
        let (base, dashes) = (y + 88.0, if dashes.is_empty() { "none" } else { dashes });
        let _ = write!(
            svg,
            "<path d=\"M{left} {y}H{right}\" stroke=\"{colour}\" stroke-width=\"42\" \
             stroke-dasharray=\"{dashes}\"/><text x=\"{text}\" y=\"{base}\">{name}</text>"
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
    let _ = write!(
        svg,
        "<circle cx=\"{centre}\" cy=\"{y}\" r=\"75\" fill=\"white\" stroke=\"black\" \
         stroke-width=\"28\"/><text x=\"{text}\" y=\"{base}\">step {step} s</text>\
         <text x=\"{text}\" y=\"{}\">others ×1.78 apart</text>",
        base + ROW
    );
}
