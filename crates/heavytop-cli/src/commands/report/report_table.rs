//! The table of a report, as text and as JSON: [`ReportTable`].

use crate::runs::{Experiment, TopInAxes};
use lie_poisson_runs::{ReportLine, SteadyRotation, TopReport};
use serde::Serialize;
use std::fmt;

/// The rates and turning points of a top, beside the formulas of textbooks, and the steady rotations near it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportTable {
    /// What kind of top it is, and about which line its angles are.
    kind: &'static str,
    /// The numbers, each with its formulas.
    numbers: Vec<Number>,
    /// The steady rotations with the vertical angular momentum of the run.
    steady: Vec<Steady>,
    /// Whether the body has no weight, so that the direction of its angular momentum stands for the vertical.
    is_free: bool,
    formulation: &'static str,
    scheme: &'static str,
    /// The size of the steps, s.
    step: f64,
    /// The end of the run, s.
    end: f64,
    /// The estimated error of the run, relative to the state.
    error_estimate: Option<f64>,
    #[serde(skip)]
    text: String,
}

/// A measured number beside those of formulas.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Number {
    name: &'static str,
    unit: &'static str,
    measured: Option<f64>,
    formulas: Vec<Formula>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Formula {
    formula: &'static str,
    value: f64,
}

/// A steady rotation, in the axes of `[body]`.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Steady {
    /// The vertical in the body.
    vertical: [f64; 3],
    /// The rate about it, rad/s.
    rate: f64,
    /// The energy above that of the run, J.
    energy_above: f64,
    /// The rate at which disturbances grow, 1/s.
    growth: f64,
    /// Whether it is one of a circle about the axis of symmetry.
    is_circle: bool,
    /// The least angle of the run from it, deg.
    nearest: f64,
}

impl ReportTable {
    /// Creates the table of the report on a run.
    pub(super) fn new(
        run: &Experiment<TopInAxes>,
        report: &TopReport,
        error_estimate: Option<f64>,
    ) -> Self {
        let number = |line: &ReportLine| Number {
            name: line.name,
            unit: line.unit,
            measured: line.measured.filter(|value| value.is_finite()),
            formulas: line
                .formulas
                .iter()
                .map(|&(formula, value)| Formula { formula, value })
                .collect(),
        };
        let steady = |rotation: &SteadyRotation| Steady {
            vertical: rotation.vertical.into(),
            rate: rotation.rate,
            energy_above: rotation.energy - report.energy,
            growth: rotation.growth,
            is_circle: rotation.is_circle,
            nearest: rotation.nearest.to_degrees(),
        };
        let (method, schedule) = (&run.method, run.pace.schedule);
        Self {
            kind: report.kind,
            numbers: report.lines.iter().map(number).collect(),
            steady: report.steady.iter().map(steady).collect(),
            is_free: report.is_free,
            formulation: method.formulation().name(),
            scheme: method.scheme().name(),
            step: schedule.step,
            end: schedule.step * schedule.steps as f64,
            error_estimate,
            text: report.to_string(),
        }
    }
}

impl fmt::Display for ReportTable {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(&self.text)
    }
}
