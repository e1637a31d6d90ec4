//! The section of another Lie–Poisson system.

use super::limits::Limits;
use super::section_problem::{Drawing, SectionProblem, visit_returns};
use super::top_problem::{crossed, followed};
use crate::configuration::{Config, Integration, SectionConfig, SystemConfig};
use crate::errors::{Error, SystemTableError};
use crate::pictures::caption::{self, number};
use crate::pictures::lettering::shortened;
use crate::pictures::symbols::symbol;
use collective_integrators::Direction;
use heavytop::methods::Method;
use lie_poisson_formula_systems::{FormulaSystem, FormulaSystemError, SystemSection};
use lie_poisson_formulas::Formula;
use lie_poisson_runs::Model;
use lie_poisson_runs::step_angle::require_run;
use serde_json::{Map, Value};

/// The number of characters after which the title of an axis is cut.
const MOST_OF_TITLE: usize = 60;

/// The section of a system, and how its points are computed.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::section) struct SystemProblem {
    section: SystemSection,
    method: Method,
    /// The initial state of `[system]`, whose invariants are those of the section.
    initial: Vec<f64>,
    /// The values of h and of the Casimirs of random starts.
    levels: Vec<f64>,
    /// The states that are given instead of random starts.
    given: Vec<Vec<f64>>,
}

impl SystemProblem {
    /// Reads the section that the configuration asks for, and what `[integrator]` leaves out.
    ///
    /// # Errors
    /// If there is no such section.
    pub fn new(config: &Config, settings: &SectionConfig) -> Result<(Self, Integration), Error> {
        let Some(table) = config.system()? else {
            return Err(SystemTableError::Missing("hamiltonian").into());
        };
        let (system, parameters) = (table.formula_system()?, table.parameters()?);
        let algebra = system.algebra().clone();
        settings.require_system()?;
        let Some(surface) = &settings.surface else { return Err(Error::NoSurface) };
        let at = (settings.level, settings.direction);
        let mut section = SystemSection::new(&system, surface, &parameters, at)
            .map_err(Error::of_system_section)?;
        if let Some([x, y]) = &settings.axes {
            section = section.with_axes([x, y], &parameters).map_err(Error::of_system_section)?;
        }
        let given = settings.states.iter();
        let given =
            given.map(|values| algebra.state(values.iter().map(|(n, v)| (&**n, v.values()))));
        let given = given.collect::<Result<Vec<_>, _>>().map_err(Error::of_system_section)?;
        let initial = match given.first() {
            // The other states do not need that of `[system]`.
            Some(first) if table.initial.is_empty() => first.clone(),
            _ => table.start(&system)?,
        };
        let mut levels = system.invariants(&initial)?;
        if let (Some(level), Some(energy)) = (levels.first_mut(), settings.energy) {
            *level = energy;
        }
        let formulation = SystemConfig::formulation_of_many(&algebra);
        let own = Integration { formulation, ..Integration::default() };
        let Integration { formulation, scheme, tolerance, .. } = config.integrator.or(own);
        let method = algebra.method(formulation, scheme, tolerance)?;
        Ok((Self { section, method, initial, levels, given }, own))
    }

    fn system(&self) -> &FormulaSystem {
        self.section.system()
    }

    /// Follows a state to the surface, and returns the point there.
    fn first_crossing(
        &self,
        limits: &Limits,
        number: usize,
        state: &[f64],
    ) -> Result<Vec<f64>, Error> {
        let mut first = None;
        let mut visit = |_: f64, state: &[f64]| {
            first = Some(state.to_vec());
            Ok(())
        };
        let limits = Limits { crossings: 1, ..*limits };
        visit_returns(self, &limits, (number, state, true), &mut visit)?;
        first.ok_or(Error::NeverCrosses { state: number, longest: limits.longest })
    }
}

impl SectionProblem for SystemProblem {
    fn model(&self) -> &dyn Model {
        self.system()
    }

    fn method(&self) -> &Method {
        &self.method
    }

    fn surface(&self) -> (Direction, Option<f64>) {
        (self.section.direction(), self.section.period())
    }

    fn value(&self, _: f64, momentum: &[f64]) -> f64 {
        self.section.value(momentum)
    }

    fn require_values(&self, _: f64, momentum: &[f64]) -> Result<(), FormulaSystemError> {
        self.section.checked_plane(momentum)?;
        self.system().invariants(momentum).map(drop)
    }

    fn warnings(&self) -> Vec<String> {
        // A method whose steps fail to be made has no warning, and refuses the first start.
        self.model().warning(&self.method, &self.initial).ok().flatten().into_iter().collect()
    }

    fn require_step(&self, step: f64) -> Result<(), Error> {
        let own = std::slice::from_ref(&self.initial);
        let states = if self.given.is_empty() { own } else { &self.given };
        let sane = |state: &Vec<f64>| require_run(self.system(), &self.method, (state, step));
        Ok(states.iter().try_for_each(sane)?)
    }

    fn complete(&self, section: SectionConfig) -> SectionConfig {
        let axes = self.section.axes().each_ref().map(ToString::to_string);
        SectionConfig { axes: Some(axes), ..section }
    }

    fn plane(&self, _: f64, state: &[f64]) -> [f64; 2] {
        self.section.plane(state)
    }

    fn conserved(&self) -> Vec<String> {
        let casimirs = (1..=self.system().casimirs().len()).map(|i| format!("c{i}"));
        ["h".to_owned()].into_iter().chain(casimirs).collect()
    }

    fn deviations(&self, start: &[f64], state: &[f64]) -> Vec<f64> {
        let invariants = |state| self.system().invariants(state).unwrap_or_default();
        let levels = match self.given.is_empty() {
            true => self.levels.clone(),
            false => invariants(start),
        };
        invariants(state).iter().zip(levels).map(|(value, level)| (value - level).abs()).collect()
    }

    fn title(&self) -> String {
        let (section, system) = (&self.section, self.system());
        let names = self.conserved();
        let formulas = names
            .iter()
            .zip(system.conserved_functions())
            .map(|(name, text)| format!("{name} = {text}"));
        let formulas = formulas.collect::<Vec<_>>().join("; ");
        format!("{formulas}; on {} = {}", section.surface(), section.level())
    }

    fn summary(&self, deviations: &[f64]) -> Map<String, Value> {
        let (section, system, names) = (&self.section, self.system(), self.conserved());
        let casimirs = system.casimirs().iter().map(|casimir| casimir.to_string().into());
        let casimirs = names.iter().skip(1).cloned().zip(casimirs).collect();
        let deviations = deviations.iter().map(|&deviation| deviation.into());
        let deviations = names.iter().cloned().zip(deviations).collect();
        let keys = [
            ("algebra", system.algebra().name().into()),
            ("hamiltonian", system.hamiltonian().to_string().into()),
            ("casimirs", Value::Object(casimirs)),
            ("surface", section.surface().to_string().into()),
            ("level", section.level().into()),
            ("deviations", Value::Object(deviations)),
        ];
        keys.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
    }

    fn drawing(&self, limits: &Limits) -> Drawing {
        let axes = self.section.axes().each_ref();
        let [x, y] = axes.map(title);
        let (formulation, scheme) = (self.method.formulation(), self.method.scheme());
        let names = self.conserved();
        let levels = names.iter().zip(&self.levels);
        let levels = levels.map(|(name, level)| format!("{} = {}", symbol(name), number(*level)));
        let levels = match self.given.is_empty() {
            true => levels.collect::<Vec<_>>().join(", "),
            false => "given states".into(),
        };
        let surface = caption::formula(self.section.surface());
        let fixed = number(self.section.level());
        let mut caption = vec![
            caption::hamiltonian(self.system().hamiltonian()),
            levels,
            format!("{surface} = {fixed}{}", crossed(self.section.direction())),
            caption::method(formulation, scheme, limits.step),
            followed(limits),
        ];
        // What a title has no room for is in the caption.
        let cut = axes.into_iter().zip(["x", "y"]).filter(|(axis, _)| title(axis).ends_with('…'));
        caption.extend(cut.map(|(axis, name)| format!("{name} = {}", caption::formula(axis))));
        Drawing { caption, abscissa: (x, false), ordinate: (y, "") }
    }

    fn starts(&self, limits: &Limits) -> Result<Vec<Vec<f64>>, Error> {
        if !self.given.is_empty() {
            let given = (1..).zip(&self.given);
            return given.map(|(n, state)| self.first_crossing(limits, n, state)).collect();
        }
        self.section
            .starts(&self.initial, &self.levels, limits.starts, limits.seed)
            .map_err(Error::of_system_section)
    }
}

/// Returns the title of an axis, a formula or its beginning. What follows a plain space and a parenthesis would be read as a
/// unit.
pub(super) fn title(axis: &Formula) -> String {
    shortened(&caption::formula(axis), MOST_OF_TITLE).replace(" (", "\u{a0}(")
}
