//! The section of a top.

use super::limits::Limits;
use super::section_problem::{Drawing, SectionProblem};
use crate::configuration::{Config, Integration, SectionConfig};
use crate::errors::Error;
use crate::pictures::caption::{self, number};
use collective_integrators::Direction;
use heavytop::methods::{Formulation, Method};
use heavytop::{EnergyLevel, Invariant, PrincipalAxes, Section, Surface, SurfaceVariable};
use lie_poisson::Se3Dual;
use lie_poisson_runs::step_angle::{USUAL_TURN, fastest_rate_of_top, require_turn};
use lie_poisson_runs::{Model, TopInAxes};
use serde_json::{Map, Value};

/// The section of an energy level of a top, and how its points are computed.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::section) struct TopProblem {
    section: Section,
    method: Method,
    model: TopInAxes,
    /// What the configuration says against its body.
    body_warning: Option<String>,
}

impl TopProblem {
    /// Reads the section that the configuration asks for, and what `[integrator]` leaves out.
    ///
    /// # Errors
    /// If there is no such section.
    pub fn new(config: &Config, settings: &SectionConfig) -> Result<(Self, Integration), Error> {
        let (top, initial) = (config.top()?, config.start()?);
        let of_initial = |invariant: Invariant| invariant.value(&top, &initial);
        let level = EnergyLevel {
            top,
            energy: settings.energy.unwrap_or(of_initial(Invariant::Energy)),
            vertical_momentum: settings
                .vertical_momentum
                .unwrap_or(of_initial(Invariant::VerticalMomentum)),
        };
        settings.require_top()?;
        let (variable, direction) = (settings.variable()?, settings.direction);
        let (axes, body_warning) = (config.axes()?, config.body_warning());
        let surface = Surface { variable, level: settings.level, direction };
        let section = Section::in_axes(level, surface, &axes)?;
        let own = Integration {
            formulation: Formulation::Reduced,
            step: USUAL_TURN / fastest_rate_of_top(&top, level.energy),
            ..Integration::default()
        };
        let method = config.integrator.or(own).method()?;
        let model = TopInAxes { axes, ..top.into() };
        Ok((Self { section, method, model, body_warning }, own))
    }

    /// Returns the state, in principal axes, with these coordinates in the axes of the table.
    fn state(&self, numbers: &[f64]) -> Se3Dual {
        self.model.axes.state_to_principal(&TopInAxes::state(numbers))
    }

    /// Returns the coordinates, in the axes of the table, of a state in principal axes.
    fn numbers(&self, mu: &Se3Dual) -> Vec<f64> {
        TopInAxes::coordinates(&self.model.given(mu)).to_vec()
    }
}

impl SectionProblem for TopProblem {
    fn model(&self) -> &dyn Model {
        &self.model
    }

    fn method(&self) -> &Method {
        &self.method
    }

    fn surface(&self) -> (Direction, Option<f64>) {
        (self.section.surface().direction, self.section.period())
    }

    fn value(&self, _: f64, momentum: &[f64]) -> f64 {
        self.section.value(&TopInAxes::state(momentum))
    }

    fn warnings(&self) -> Vec<String> {
        let of_method = TopInAxes::method_warning(&self.method);
        let warnings = [of_method, self.body_warning.clone()];
        warnings.into_iter().flatten().collect()
    }

    fn require_step(&self, step: f64) -> Result<(), Error> {
        let EnergyLevel { top, energy, .. } = self.section.level();
        Ok(require_turn(step, step.abs() * fastest_rate_of_top(top, *energy))?)
    }

    fn complete(&self, section: SectionConfig) -> SectionConfig {
        let level = self.section.level();
        SectionConfig {
            energy: Some(level.energy),
            vertical_momentum: Some(level.vertical_momentum),
            surface: Some(self.section.surface().variable.name().into()),
            ..section
        }
    }

    fn plane(&self, _: f64, numbers: &[f64]) -> [f64; 2] {
        self.section.plane(&self.state(numbers)).into()
    }

    fn conserved(&self) -> Vec<String> {
        ["h", "f1", "f2"].map(String::from).to_vec()
    }

    fn deviations(&self, _: &[f64], numbers: &[f64]) -> Vec<f64> {
        let level = self.section.level();
        let expected = [
            (Invariant::Energy, level.energy),
            (Invariant::VerticalSquared, 1.0),
            (Invariant::VerticalMomentum, level.vertical_momentum),
        ];
        let mu = self.state(numbers);
        let deviation = |(f, value): (Invariant, f64)| (f.value(&level.top, &mu) - value).abs();
        expected.map(deviation).to_vec()
    }

    fn title(&self) -> String {
        let EnergyLevel { energy, vertical_momentum, .. } = self.section.level();
        let [energy, vertical_momentum] = [*energy, *vertical_momentum].map(number);
        let Surface { variable, level, .. } = self.section.surface();
        let surface = format!("on {variable} = {}", number(*level));
        format!("h = {energy} J, Pi.Gamma = {vertical_momentum} kg m²/s; {surface}")
    }

    fn summary(&self, deviations: &[f64]) -> Map<String, Value> {
        let EnergyLevel { energy, vertical_momentum, .. } = *self.section.level();
        let level = [("energy", energy), ("vertical_momentum", vertical_momentum)];
        let level = level.map(|(name, value)| (name.to_owned(), value));
        let deviations = self.conserved().into_iter().zip(deviations.iter().copied());
        level.into_iter().chain(deviations).map(|(name, value)| (name, value.into())).collect()
    }

    fn drawing(&self, limits: &Limits) -> Drawing {
        let Surface { variable, .. } = self.section.surface();
        let index = index(*variable);
        let angle = (format!("angle of Γ about e{index} (rad)"), true);
        let (abscissa, ordinate) = match variable {
            SurfaceVariable::Coordinate(coordinate) if coordinate.is_momentum() => {
                (angle, (format!("Γ{index}"), ""))
            }
            SurfaceVariable::Coordinate(_) => (angle, (format!("Π{index}"), " (kg m²/s)")),
            _ => {
                let inclination = (format!("inclination of Γ to e{index} (rad)"), false);
                (inclination, ("Π·n".into(), " (kg m²/s)"))
            }
        };
        Drawing {
            caption: words(&self.section, &self.model.axes, &self.method, limits),
            abscissa,
            ordinate,
        }
    }

    fn starts(&self, limits: &Limits) -> Result<Vec<Vec<f64>>, Error> {
        let starts = self.section.starts(limits.starts, limits.seed)?;
        Ok(starts.iter().map(|mu| self.numbers(mu)).collect())
    }
}

fn index(variable: SurfaceVariable) -> &'static str {
    ["₁", "₂", "₃"][variable.axis()]
}

/// Returns the parts of the caption: level, surface, top, method and starts.
fn words(section: &Section, axes: &PrincipalAxes, method: &Method, limits: &Limits) -> Vec<String> {
    let EnergyLevel { top, energy, vertical_momentum } = section.level();
    let Surface { variable, level, direction } = section.surface();
    let index = index(*variable);
    let level = number(*level);
    let (fixed, node) = match variable {
        SurfaceVariable::Coordinate(coordinate) if coordinate.is_momentum() => {
            (format!("Π{index} = {level} kg m²/s"), String::new())
        }
        SurfaceVariable::Coordinate(_) => (format!("Γ{index} = {level}"), String::new()),
        _ => {
            let node = format!("; n = e{index} × Γ/|e{index} × Γ|");
            (format!("angle of Γ about e{index} = {level} rad"), node)
        }
    };
    let [energy, vertical_momentum] = [*energy, *vertical_momentum].map(number);
    vec![
        format!(
            "<tspan font-style='italic'>h</tspan> = {energy} J, Π·Γ = {vertical_momentum} kg m²/s"
        ),
        format!("{fixed}{}{node}", crossed(*direction)),
        caption::top_in(top, axes),
        caption::method(method.formulation(), method.scheme(), limits.step),
        followed(limits),
    ]
}

/// Returns the words for the direction of the crossings that count.
pub(super) fn crossed(direction: Direction) -> &'static str {
    match direction {
        Direction::Up => ", increasing",
        Direction::Down => ", decreasing",
        Direction::Both => "",
    }
}

/// Returns the words for how far the starts are followed.
pub(super) fn followed(limits: &Limits) -> String {
    let Limits { starts, crossings, longest, .. } = limits;
    let longest = number(*longest);
    format!("{starts} starts, {crossings} returns each, at most {longest} s")
}
