//! The section of a motion that is driven, damped, noisy or under a torque.

use super::limits::Limits;
use super::section_problem::{Drawing, SectionProblem};
use super::system_problem::title;
use super::top_problem::{crossed, followed};
use crate::configuration::{Config, Integration, OpenModel, OpenStart, SectionConfig};
use crate::errors::Error;
use crate::pictures::caption::{self, number};
use collective_integrators::Direction;
use heavytop::methods::Method;
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_formulas::{Formula, Parameters};
use lie_poisson_runs::step_angle::require_run;
use lie_poisson_runs::{Model, directed_step};
use serde_json::{Map, Value};

/// The states, at any time, on a surface of the coordinates, the time and the inputs: once a period of a drive for sin ωt, say.
///
/// No energy tells where such motions are. The starts are states at t = 0 that are given, or the initial state and random ones of its
/// coadjoint orbit, and each is followed to its first point.
#[derive(Clone, Debug)]
pub(in crate::commands::section) struct OpenProblem {
    model: OpenModel,
    method: Method,
    surface: Formula,
    level: f64,
    direction: Direction,
    axes: [Formula; 2],
    initial: Vec<f64>,
    /// The states that are given instead of random ones.
    given: Vec<Vec<f64>>,
    /// The Hamiltonian or the body, and the forces, as parts of a caption.
    about: Vec<String>,
}

impl OpenProblem {
    /// Reads the section that the configuration asks for, and what `[integrator]` leaves out.
    ///
    /// # Errors
    /// If there is no such section.
    pub fn new(config: &Config, settings: &SectionConfig) -> Result<(Self, Integration), Error> {
        settings.require_open()?;
        let OpenStart { model, start: initial, method } = config.open_start(None)?;
        let own = Integration { formulation: method.formulation(), ..Integration::default() };
        require_inputs(config, &model, (settings.longest, config.integrator.or(own)))?;
        let parameters = match config.system()? {
            Some(table) => table.named_parameters()?,
            None => Parameters::new(),
        };
        let algebra = model.system().base().algebra();
        let names = config.named_inputs()?.vocabulary(algebra, &parameters)?;
        let Some(text) = &settings.surface else { return Err(Error::NoSurface) };
        let surface = Formula::new(text, &names).map_err(FormulaSystemError::Surface);
        let surface = surface.map_err(Error::of_system_section)?;
        if !settings.level.is_finite() {
            let error = FormulaSystemError::Level { value: settings.level };
            return Err(Error::of_system_section(error));
        }
        if model.as_model().noise().is_some() && !model.system().is_of_time(&surface) {
            let key = "section.surface".into();
            return Err(Error::NoisyFunction { key, function: text.clone() });
        }
        let own_axes = || first_axes(&model.as_model().columns(), text);
        let texts = settings.axes.clone().or_else(own_axes).ok_or_else(|| {
            Error::of_system_section(FormulaSystemError::NoAxes { dimension: algebra.dimension() })
        })?;
        let axis = |(axis, text): (usize, &String)| {
            let problem = |problem| FormulaSystemError::Axis { axis, problem };
            Formula::new(text, &names).map_err(problem).map_err(Error::of_system_section)
        };
        let [x, y] = &texts;
        let axes = [axis((0, x))?, axis((1, y))?];
        let given = settings.states.iter();
        let given =
            given.map(|values| algebra.state(values.iter().map(|(n, v)| (&**n, v.values()))));
        let given = given.collect::<Result<Vec<_>, _>>().map_err(Error::of_system_section)?;
        let about = about(config, &model)?;
        let (level, direction) = (settings.level, settings.direction);
        let made = Self { model, method, surface, level, direction, axes, initial, given, about };
        Ok((made, own))
    }

    /// Returns the coordinates, the time and the inputs, which formulas name.
    fn named(&self, time: f64, momentum: &[f64]) -> Vec<f64> {
        let mut x = momentum.to_vec();
        self.model.as_model().append_inputs(time, &mut x);
        x
    }

    /// Returns the values of what the motion keeps.
    fn kept(&self, state: &[f64]) -> Vec<f64> {
        let (conserved, mut values) = (self.model.as_model().conserved(&self.initial), Vec::new());
        conserved.append(0.0, state, &mut values);
        let named = conserved.names().into_iter().zip(values);
        named.filter(|(name, _)| conserved.is_kept(name)).map(|(_, value)| value).collect()
    }
}

/// Checks that the inputs reach to the last step of the longest run.
fn require_inputs(
    config: &Config,
    model: &OpenModel,
    (longest, Integration { step, end, .. }): (f64, Integration),
) -> Result<(), Error> {
    let step = directed_step(step, end)?;
    let last = (longest / step.abs()).ceil() * step;
    match last.is_finite() {
        true => config.require_inputs(&model.system().terms().inputs, last),
        // The limits of the section refuse it.
        false => Ok(()),
    }
}

/// Returns the first two coordinates, apart from one that is the surface.
fn first_axes(columns: &[String], surface: &str) -> Option<[String; 2]> {
    let mut free = columns.iter().filter(|name| *name != surface).cloned();
    Some([free.next()?, free.next()?])
}

/// Returns what moves, and the forces.
fn about(config: &Config, model: &OpenModel) -> Result<Vec<String>, Error> {
    let moves = match model {
        OpenModel::Top(_) => {
            let top = config.model()?;
            caption::top_in(&top.top, &top.axes)
        }
        OpenModel::System(system) => {
            let own = system.base().hamiltonian();
            caption::hamiltonian(system.terms().hamiltonian.as_ref().unwrap_or(own))
        }
    };
    Ok([moves].into_iter().chain(config.forces()).collect())
}

impl SectionProblem for OpenProblem {
    fn model(&self) -> &dyn Model {
        self.model.as_model()
    }

    fn method(&self) -> &Method {
        &self.method
    }

    fn surface(&self) -> (Direction, Option<f64>) {
        (self.direction, self.surface.period())
    }

    fn value(&self, time: f64, momentum: &[f64]) -> f64 {
        let difference = self.surface.value_at(&self.named(time, momentum)) - self.level;
        match self.surface.period() {
            Some(period) => difference - period * (difference / period).round(),
            None => difference,
        }
    }

    fn starts_on_surface(&self) -> bool {
        false
    }

    fn require_values(&self, time: f64, momentum: &[f64]) -> Result<(), FormulaSystemError> {
        let x = self.named(time, momentum);
        Ok(self.axes.iter().try_for_each(|axis| axis.checked_value(&x).map(drop))?)
    }

    fn warnings(&self) -> Vec<String> {
        // A method whose steps fail to be made has no warning, and refuses the first start.
        self.model().warning(&self.method, &self.initial).ok().flatten().into_iter().collect()
    }

    fn require_step(&self, step: f64) -> Result<(), Error> {
        let own = std::slice::from_ref(&self.initial);
        let states = if self.given.is_empty() { own } else { &self.given };
        let sane = |state: &Vec<f64>| require_run(self.model(), &self.method, (state, step));
        Ok(states.iter().try_for_each(sane)?)
    }

    fn complete(&self, section: SectionConfig) -> SectionConfig {
        let axes = self.axes.each_ref().map(ToString::to_string);
        SectionConfig { axes: Some(axes), ..section }
    }

    fn plane(&self, time: f64, state: &[f64]) -> [f64; 2] {
        let x = self.named(time, state);
        self.axes.each_ref().map(|axis| axis.value_at(&x))
    }

    fn conserved(&self) -> Vec<String> {
        let conserved = self.model().conserved(&self.initial);
        conserved.names().into_iter().filter(|name| conserved.is_kept(name)).collect()
    }

    fn deviations(&self, start: &[f64], state: &[f64]) -> Vec<f64> {
        let before = self.kept(start).into_iter();
        self.kept(state).into_iter().zip(before).map(|(now, before)| (now - before).abs()).collect()
    }

    fn title(&self) -> String {
        let equation = |name: &str| Some(format!("{name} = {}; ", self.model().formula(name)?));
        let casimirs = self.conserved();
        let equations: String = ["h"]
            .into_iter()
            .chain(casimirs.iter().map(String::as_str))
            .filter_map(equation)
            .collect();
        format!("{equations}on {} = {}", self.surface, self.level)
    }

    fn summary(&self, deviations: &[f64]) -> Map<String, Value> {
        let deviations = self.conserved().into_iter().zip(deviations.iter().map(|&d| d.into()));
        let keys = [
            ("algebra", self.model().algebra_name().into()),
            ("hamiltonian", self.model().formula("h").into()),
            ("surface", self.surface.to_string().into()),
            ("level", self.level.into()),
            ("deviations", Value::Object(deviations.collect())),
        ];
        keys.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
    }

    fn drawing(&self, limits: &Limits) -> Drawing {
        let [x, y] = self.axes.each_ref().map(title);
        let (formulation, scheme) = (self.method.formulation(), self.method.scheme());
        let (surface, fixed) = (caption::formula(&self.surface), number(self.level));
        let mut caption = self.about.clone();
        caption.extend([
            format!("{surface} = {fixed}{}", crossed(self.direction)),
            caption::method(formulation, scheme, limits.step),
            followed(limits),
        ]);
        Drawing { caption, abscissa: (x, false), ordinate: (y, "") }
    }

    fn starts(&self, limits: &Limits) -> Result<Vec<Vec<f64>>, Error> {
        if !self.given.is_empty() {
            return Ok(self.given.clone());
        }
        let base = self.model.system().base();
        let states = base.orbit_states(&self.initial, limits.starts, limits.seed);
        states.map_err(Error::of_system_section)
    }
}
