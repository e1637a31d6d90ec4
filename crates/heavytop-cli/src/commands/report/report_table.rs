//! The table of a report, as text and as JSON: [`ReportTable`].

use crate::runs::{Experiment, TopInAxes};
use crate::vocabulary::brief::number;
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
    /// Creates the table of the report on a run. The height is told if the distance of the centre of mass (m) is known.
    pub(super) fn new(
        run: &Experiment<TopInAxes>,
        report: &TopReport,
        length: Option<f64>,
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
        let mut numbers: Vec<Number> = report.lines.iter().map(number).collect();
        if let (Some(length), true) = (length, run.model.top.weight_moment() > 0.0) {
            let inclination = |name: &str| {
                let line = report.lines.iter().find(|line| line.name.starts_with(name));
                line.and_then(|line| line.measured).map(|angle| length * angle.to_radians().cos())
            };
            let heights = [("least height", "largest"), ("largest height", "least")];
            numbers.extend(heights.map(|(name, angle)| Number {
                name,
                unit: "m",
                measured: inclination(&format!("{angle} inclination")),
                formulas: Vec::new(),
            }));
        }
        let steady = |rotation: &SteadyRotation| Steady {
            vertical: run.model.axes.from_principal(&rotation.vertical).into(),
            rate: rotation.rate,
            energy_above: rotation.energy - report.energy,
            growth: rotation.growth,
            is_circle: rotation.is_circle,
            nearest: rotation.nearest.to_degrees(),
        };
        let (method, schedule) = (&run.method, run.pace.schedule);
        Self {
            kind: report.kind,
            numbers,
            steady: report.steady.iter().map(steady).collect(),
            is_free: run.model.top.weight_moment() == 0.0,
            formulation: method.formulation().name(),
            scheme: method.scheme().name(),
            step: schedule.step,
            end: schedule.step * schedule.steps as f64,
            error_estimate,
        }
    }
}

/// Returns a number with six digits.
fn short(value: f64) -> String {
    number(format!("{value:.5e}").parse().unwrap_or(value))
}

impl fmt::Display for ReportTable {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(to, "{}", self.kind)?;
        for Number { name, unit, measured, formulas } in &self.numbers {
            let measured =
                measured.map_or("not in this run".into(), |x| format!("{} {unit}", short(x)));
            writeln!(to, "  {name:<50} {measured}")?;
            for Formula { formula, value } in formulas {
                writeln!(to, "    {formula:<48} {} {unit}", short(*value))?;
            }
        }
        if !self.steady.is_empty() {
            writeln!(
                to,
                "steady rotations with the same angular momentum, those of least energy first"
            )?;
        }
        for steady in &self.steady {
            let vertical = steady.vertical.map(|x| format!("{:.4}", x + 0.0)).join(", ");
            let circle = if steady.is_circle { ", and about the axis" } else { "" };
            let direction = if self.is_free { "L along" } else { "Γ =" };
            writeln!(to, "  {direction} ({vertical}){circle}")?;
            let stability = match steady.growth {
                0.0 => "disturbances do not grow".to_string(),
                growth => format!("disturbances grow e-fold in {} s", short(1.0 / growth)),
            };
            writeln!(
                to,
                "    Ω = {} rad/s; {stability}; the run comes as near as {} deg",
                short(steady.rate),
                short(steady.nearest)
            )?;
        }
        Ok(())
    }
}
