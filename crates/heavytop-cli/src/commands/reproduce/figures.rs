//! The six figures of the paper, and the curves in each.

use super::record::{QUANTITIES, Record};
use crate::pictures::caption;
use crate::pictures::curves::curve::{BLUE, Curve, DASHED, DOTTED, GRAY, GREEN, RED, WHOLE};
use heavytop::Invariant;
use heavytop::methods::{Formulation, Method, SchemeName};
use plotters::style::RGBColor;

/// A figure: one conserved quantity along several runs.
#[derive(Clone, Debug)]
pub(super) struct Figure<'a> {
    /// The name of the figure's file, without ending.
    pub name: &'static str,
    /// The label of the ordinate, as the inside of an SVG text.
    pub label: &'static str,
    /// The curves in the order of the legend.
    pub curves: Vec<Curve<'a>>,
    /// The parts of the caption: the top, its start, and the steps.
    pub caption: Vec<String>,
}

type Line = (Formulation, SchemeName, RGBColor, &'static str);

/// The curves of Fig. 1. Source: its caption in Ohsawa 2019.
const FIGURE_1: [Line; 3] = [
    (Formulation::Collective, SchemeName::ExplicitMidpoint, BLUE, DASHED),
    (Formulation::Direct, SchemeName::ExplicitMidpoint, GREEN, DOTTED),
    (Formulation::Collective, SchemeName::ImplicitMidpoint, RED, WHOLE),
];

/// The curves of Fig. 2. Source: its caption in Ohsawa 2019.
const FIGURE_2: [Line; 2] = [
    (Formulation::Direct, SchemeName::ImplicitMidpoint, GRAY, DASHED),
    (Formulation::Collective, SchemeName::ImplicitMidpoint, RED, WHOLE),
];

/// The six figures of the paper: the names of their files without ending, their quantities and their curves.
const FIGURES: [(&str, Invariant, &[Line]); 6] = [
    ("fig1a", Invariant::Energy, &FIGURE_1),
    ("fig1b", Invariant::VerticalSquared, &FIGURE_1),
    ("fig1c", Invariant::VerticalMomentum, &FIGURE_1),
    ("fig1d", Invariant::Kovalevskaya, &FIGURE_1),
    ("fig2a", Invariant::Energy, &FIGURE_2),
    ("fig2b", Invariant::Kovalevskaya, &FIGURE_2),
];

/// Returns the names of the files of the figures, without ending.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    FIGURES.into_iter().map(|(name, ..)| name)
}

/// Returns the six figures of the paper.
pub(super) fn all(records: &[Record]) -> Vec<Figure<'_>> {
    let figure = |(name, quantity, lines): (_, _, &[Line])| {
        let curves = lines.iter().filter_map(|line| curve(records, quantity, line)).collect();
        let caption = records.first().map_or_else(Vec::new, words);
        Figure { name, label: label(quantity), curves, caption }
    };
    FIGURES.into_iter().map(figure).collect()
}

/// Returns what all curves share.
fn words(record: &Record) -> Vec<String> {
    let run = &record.experiment;
    let [step, end] = [run.pace.schedule.step, run.pace.schedule.end()].map(caption::number);
    let steps = format!("step {step} s, 0 to {end} s");
    vec![caption::top(&run.model.top), caption::start(&run.initial_state()), steps]
}

fn curve<'a>(records: &'a [Record], quantity: Invariant, line: &Line) -> Option<Curve<'a>> {
    let &(formulation, scheme, colour, dashes) = line;
    let column = QUANTITIES.iter().position(|&q| q == quantity)?;
    let of_line = |m: &Method| m.formulation() == formulation && m.scheme() == scheme;
    let points = &records.iter().find(|r| of_line(&r.experiment.method))?.curves[column];
    let name = format!("{}, {}", scheme.name().replace('-', " "), formulation.name());
    Some(Curve { name, colour, dashes, points })
}

/// Returns the symbol and the unit. The subscripts are lowered digits, for not every viewer knows `baseline-shift`.
fn label(quantity: Invariant) -> &'static str {
    match quantity {
        Invariant::Energy => "<tspan font-style='italic'>h</tspan> (J)",
        Invariant::VerticalSquared => "<tspan font-style='italic'>f</tspan>₁",
        Invariant::VerticalMomentum => "<tspan font-style='italic'>f</tspan>₂ (kg m²/s)",
        Invariant::Kovalevskaya => "<tspan font-style='italic'>K</tspan> ((kg m²/s)⁴)",
        Invariant::AxialMomentum | Invariant::GoryachevChaplygin | Invariant::MomentumSquared => "",
    }
}
