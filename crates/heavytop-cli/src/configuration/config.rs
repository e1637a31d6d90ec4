//! The tables of a configuration file.

use super::events_config::EventsConfig;
use super::integrator_config::{Integration, IntegratorConfig};
use super::notes::Notes;
use super::open::{DampingConfig, Element, InputConfig, NoiseConfig};
use super::output_config::OutputConfig;
use super::section_config::SectionConfig;
use super::sweep::SweepConfig;
use super::system::SystemConfig;
use super::top::{About, BodyConfig, InitialConfig, LeftOut};
use crate::errors::{CheckpointError, Error, SystemTableError};
use crate::runs::top_columns::TopColumns;
use crate::runs::{Experiment, Pace, Schedule, TopInAxes};
use heavytop::methods::Formulation;
use heavytop::{HeavyTop, PrincipalAxes};
use lie_poisson::{InstructionSet, Se3Dual};
use lie_poisson_formula_systems::FormulaSystem;
use lie_poisson_runs::step_angle::require_sane_step;
use lie_poisson_runs::{OpenArrays, TopQuantity};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The keys that say where the centre of mass is, and how heavy it is.
const POSITION: [&str; 2] = ["body.mass", "body.length"];

/// The part of a velocity up to which it is zero by rounding.
const ROUNDING: f64 = 1e-12;

/// What follows the reason why a body is impossible, in a warning.
pub(crate) const IMPOSSIBLE: &str = "goes on with m g l alone: write moments about the support, or inertia_about = \
                                     \"center-of-mass\", or weight_moment instead of mass, gravity and length";

/// A configuration file; what it leaves out is as for the paper's Kovalevskaya top.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Config {
    /// The table `[body]`: the parameters of the top.
    pub body: BodyConfig,
    /// The table `[initial]`: the state at t = 0.
    pub initial: InitialConfig,
    /// The table `[integrator]`: the method and its steps.
    pub integrator: IntegratorConfig,
    /// The table `[output]`: what is written.
    pub output: OutputConfig,
    /// The table `[events]`: whose zeros `events` finds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub events: Option<EventsConfig>,
    /// The table `[section]`; without it, the section with the energy and vertical momentum of `[initial]`.
    pub section: Option<SectionConfig>,
    /// The table `[sweep]`; without it, for a top, a small sweep over angular momenta.
    pub sweep: Option<SweepConfig>,
    /// The table `[system]`: a system instead of a top.
    pub system: Option<SystemConfig>,
    /// The table `[inputs]`: inputs by tables, for formulas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inputs: Option<BTreeMap<String, InputConfig>>,
    /// The table `[drive]`: a control, an element of the algebra by formulas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drive: Option<Element>,
    /// The table `[damping]`: friction that keeps the Casimirs, or the viscosity of a fluid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub damping: Option<DampingConfig>,
    /// The table `[noise]`: noise that keeps the Casimirs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise: Option<NoiseConfig>,
    /// The table `[torque]`: a torque by formulas, or the force on a fluid by its coefficients.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque: Option<Element>,
    /// The keys that were left out of the tables of tops where they were read.
    #[serde(skip)]
    pub left_out: LeftOut,
}

impl Config {
    /// Returns the run that the configuration asks for, of a top or of a system.
    ///
    /// # Errors
    /// If there is no such run.
    pub fn run(&self) -> Result<Box<Experiment>, Error> {
        if let Some(system) = self.system()?
            && let Some(kind) = system.array_kind()
        {
            self.require_output_of_system()?;
            if let Some(open) = self.open_arrays(kind)? {
                return Ok(Box::new(open));
            }
            if let Some(arrays) = system.array_experiment(self.integrator, self.output.every)? {
                return Ok(Box::new(arrays));
            }
        }
        if let Some(open) = self.open_run()? {
            return Ok(open);
        }
        Ok(match self.system_experiment()? {
            Some(system) => Box::new(system),
            None => Box::new(self.experiment()?),
        })
    }

    /// Returns the run of the top that the configuration asks for.
    ///
    /// # Errors
    /// If there is no such run.
    pub fn experiment(&self) -> Result<Experiment<TopInAxes>, Error> {
        self.require_closed()?;
        let model = self.model()?;
        let start = TopInAxes::coordinates(&self.start()?).to_vec();
        let integration = self.integrator.or(Integration::default());
        let Integration { formulation, step, end, .. } = integration;
        let method = integration.method()?;
        let (every, attitude) = (self.output.every, self.output.has_attitude());
        if every == 0 {
            let (name, range) = ("output.every", "at least 1");
            return Err(Error::OutOfRange { name, range, value: 0.0 });
        }
        if attitude && formulation == Formulation::Direct {
            return Err(self.without_attitude(formulation));
        }
        require_sane_step(&model, &start, step)?;
        self.top_columns()?;
        let pace = Pace { schedule: Schedule::new(step, end)?, every };
        Ok(Experiment { model, start, method, pace, attitude })
    }

    /// Returns the top, and the attitude from which it starts if the configuration gives one.
    ///
    /// # Errors
    /// If there is no such top.
    pub(crate) fn model(&self) -> Result<TopInAxes, Error> {
        let initial_attitude = self.initial.attitude()?;
        Ok(TopInAxes { top: self.top()?, axes: self.axes()?, initial_attitude })
    }

    /// Returns the error that a formulation has no attitude, which the output needs.
    fn without_attitude(&self, formulation: Formulation) -> Error {
        let needs = |quantity: &&TopQuantity| !self.output.attitude && quantity.needs_attitude();
        match self.output.columns.iter().find(needs) {
            Some(quantity) => Error::ColumnOfAttitude { column: quantity.name(), formulation },
            None => lie_poisson_runs::RunFailure::NoAttitude { formulation }.into(),
        }
    }

    /// Returns the distance from the support to the centre of mass, m, if the configuration gives it.
    pub(crate) fn known_length(&self) -> Option<f64> {
        let is_known = self.body.weight_moment.is_none() && !self.leaves_out_position();
        is_known.then_some(self.body.length)
    }

    /// Returns the columns of a top that are written on request, if there are any.
    ///
    /// # Errors
    /// If there is no such top, or the distance of its centre of mass, which the height needs, is not known.
    pub(crate) fn top_columns(&self) -> Result<Option<TopColumns>, Error> {
        let quantities = self.output.columns.clone();
        if quantities.is_empty() {
            return Ok(None);
        }
        if quantities.contains(&TopQuantity::Height) && self.known_length().is_none() {
            return Err(Error::UnknownLength);
        }
        let (length, has_attitude) = (self.body.length, self.output.has_attitude());
        Ok(Some(TopColumns { model: self.model()?, length, quantities, has_attitude }))
    }

    /// Returns the instruction set on which the last digits of a run depend here: [`Method::instructions`].
    ///
    /// [`Method::instructions`]: heavytop::methods::Method::instructions
    pub(crate) fn instructions(&self) -> InstructionSet {
        let method = self.integrator.or(Integration::default()).method();
        match method {
            Ok(method) if self.system.is_none() => method.fastest().instructions(),
            // Sums over many sites, and products of matrices, are in the widest registers.
            _ if self.system.as_ref().is_some_and(|system| system.array_kind().is_some()) => {
                InstructionSet::detected()
            }
            // All methods of systems by formula are portable.
            _ => InstructionSet::Portable,
        }
    }

    /// Checks that the steps round here as those of an interrupted run did.
    ///
    /// # Errors
    /// [`CheckpointError::Instructions`] if their last digits depend on another instruction set.
    pub(crate) fn require_instructions(&self, there: &str) -> Result<(), CheckpointError> {
        let here = self.instructions().to_string();
        match there == here {
            true => Ok(()),
            false => Err(CheckpointError::Instructions { there: there.into(), here }),
        }
    }

    /// Returns the configuration with all keys of `[integrator]` that `simulate` uses, also those left out.
    #[must_use]
    pub(crate) fn with_integrator(&self) -> Self {
        let usual = Integration::default();
        if let Some(formulation) = self.opened_formulation() {
            let own = Integration { formulation, scheme: OpenArrays::SCHEME, ..usual };
            return Self { integrator: self.integrator.or(own).into(), ..self.clone() };
        }
        let mut integrator: IntegratorConfig = self.integrator.or(usual).into();
        if self.system.is_some() || self.open_table().is_some() {
            // The formulation of a system depends on its algebra, and that of an open top on its forces.
            integrator.formulation = self.integrator.formulation;
        }
        Self { integrator, ..self.clone() }
    }

    /// Returns the run of the system that the configuration asks for, or `None` if it asks for a top.
    ///
    /// # Errors
    /// If there is no such run.
    pub fn system_experiment(&self) -> Result<Option<Experiment<FormulaSystem>>, Error> {
        let Some(system) = self.system()? else { return Ok(None) };
        self.require_output_of_system()?;
        self.require_closed()?;
        system.experiment(self.integrator, self.output.every).map(Some)
    }

    /// Checks that a system can have the output that is asked for.
    pub(super) fn require_output_of_system(&self) -> Result<(), Error> {
        if self.output.attitude {
            return Err(SystemTableError::NoAttitude.into());
        }
        if let Some(quantity) = self.output.columns.first() {
            return Err(SystemTableError::ColumnOfTops { column: quantity.name() }.into());
        }
        if self.output.every == 0 {
            let (name, range) = ("output.every", "at least 1");
            return Err(Error::OutOfRange { name, range, value: 0.0 });
        }
        Ok(())
    }

    /// Returns the table `[system]`, or `None` if the configuration asks for a top.
    ///
    /// # Errors
    /// If a table of tops stands beside it.
    pub(crate) fn system(&self) -> Result<Option<&SystemConfig>, Error> {
        let Some(system) = &self.system else { return Ok(None) };
        if self.body != BodyConfig::default() {
            return Err(SystemTableError::Top("body").into());
        }
        if self.initial != InitialConfig::default() {
            return Err(SystemTableError::Top("initial").into());
        }
        Ok(Some(system))
    }

    /// Returns the top of `[body]`, in its principal axes.
    ///
    /// # Errors
    /// The errors of [`BodyConfig::top`], or that there is a system instead of a top.
    pub fn top(&self) -> Result<HeavyTop, Error> {
        match self.system {
            Some(_) => Err(SystemTableError::CommandOfTops.into()),
            None => {
                self.require_position()?;
                self.body.top()
            }
        }
    }

    /// Returns the principal axes of the top in the axes of `[body]`.
    ///
    /// # Errors
    /// The errors of [`BodyConfig::axes`].
    pub fn axes(&self) -> Result<PrincipalAxes, Error> {
        self.body.axes()
    }

    /// Returns the state of `[initial]`, in the principal axes of the top.
    ///
    /// # Errors
    /// The errors of [`InitialConfig::start`] and of [`BodyConfig::axes`], or that a thin rod turns about itself.
    pub fn start(&self) -> Result<Se3Dual, Error> {
        let (start, axes) = (self.initial.start(&self.body)?, self.axes()?);
        let start = axes.state_to_principal(&start);
        // Whether there is such a top is not for the start to say.
        let Ok(top) = self.body.top() else { return Ok(start) };
        if let (Some(axis), Some(velocity)) = (top.rod_axis(), self.initial.angular_velocity) {
            let velocity = axes.to_principal(&velocity.into());
            if velocity[axis].abs() > ROUNDING * velocity.amax() {
                let (name, range) = ("initial.angular_velocity", "at right angles to a thin rod");
                return Err(Error::OutOfRange { name, range, value: velocity[axis] });
            }
        }
        top.require_state(&start).map_err(Error::Spin)?;
        Ok(start)
    }

    /// Returns what the end of a run tells of the configuration: nothing if it is that of a system.
    #[must_use]
    pub fn notes(&self) -> Notes {
        match self.system {
            Some(_) => Notes::default(),
            None => Notes::new(&self.body, &self.left_out),
        }
    }

    /// Returns a warning if no body has the moments that the configuration gives, with the mass and the length that it
    /// gives.
    pub(crate) fn body_warning(&self) -> Option<String> {
        if self.system.is_some() || self.leaves_out_position() {
            return None;
        }
        let reason = self.body.impossibility()?;
        Some(format!("warning: [body] {reason}; the run {IMPOSSIBLE}"))
    }

    /// Returns whether the mass or the length was left out where the configuration was read.
    fn leaves_out_position(&self) -> bool {
        POSITION.iter().any(|key| self.left_out.contains(key))
    }

    /// Returns whether the mass and the length are known of a body, some of whose keys are set elsewhere.
    pub(crate) fn gives_position(&self, is_set: impl Fn(&str) -> bool) -> bool {
        let is_given =
            |key: &str| self.body.weight_moment.is_none() && !self.left_out.contains(key);
        POSITION.iter().all(|key| is_set(key) || is_given(key))
    }

    /// Checks that the mass and the length are given where the moments need them.
    pub(crate) fn require_position(&self) -> Result<(), Error> {
        match self.body.inertia_about {
            About::CenterOfMass if self.leaves_out_position() => Err(Error::CentralMoments),
            _ => Ok(()),
        }
    }
}
