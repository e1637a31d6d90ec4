//! The configuration file.

use super::integrator_config::{Integration, IntegratorConfig};
use super::section_config::SectionConfig;
use super::sweep_config::SweepConfig;
use super::top_config::{BodyConfig, InitialConfig};
use crate::Error;
use crate::runs::step_angle::require_sane_step;
use crate::runs::{Experiment, Method, Schedule};
use crate::vocabulary::Formulation;
use heavytop::HeavyTop;
use lie_poisson::Se3Dual;
use serde::{Deserialize, Serialize};

/// A configuration; what is left out is the paper's Kovalevskaya top.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Config {
    /// `[body]`
    pub body: BodyConfig,
    /// `[initial]`
    pub initial: InitialConfig,
    /// `[integrator]`
    pub integrator: IntegratorConfig,
    /// `[output]`
    pub output: OutputConfig,
    /// `[section]`; without it that of the energy and vertical momentum of `[initial]`.
    pub section: Option<SectionConfig>,
    /// `[sweep]`; without it a small sweep over angular momenta.
    pub sweep: Option<SweepConfig>,
}

/// `[output]`: what is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct OutputConfig {
    /// Every n-th step is kept, and the last.
    pub every: u64,
    /// Whether the attitude is written.
    pub attitude: bool,
}

impl Default for OutputConfig {
    fn default() -> Self {
        Self { every: 1, attitude: false }
    }
}

impl Config {
    /// The experiment that the configuration asks for.
    ///
    /// # Errors
    /// If there is no such experiment.
    pub fn experiment(&self) -> Result<Experiment, Error> {
        let (top, start) = (self.top()?, self.start()?);
        let Integration { formulation, scheme, step, end, tolerance } =
            self.integrator.or(Integration::default());
        let method = Method::new(formulation, scheme, tolerance)?;
        let OutputConfig { every, attitude } = self.output;
        if every == 0 {
            return Err(Error::OutOfRange { name: "every", range: "at least 1", value: 0.0 });
        }
        if attitude && formulation == Formulation::Direct {
            return Err(Error::NoAttitude { formulation });
        }
        require_sane_step(&top, &start, step)?;
        let schedule = Schedule::new(step, end)?;
        Ok(Experiment { top, start, method, schedule, every, attitude })
    }

    /// The top of `[body]`.
    ///
    /// # Errors
    /// As [`BodyConfig::top`].
    pub fn top(&self) -> Result<HeavyTop, Error> {
        self.body.top()
    }

    /// The state of `[initial]`.
    ///
    /// # Errors
    /// As [`InitialConfig::start`].
    pub fn start(&self) -> Result<Se3Dual, Error> {
        self.initial.start()
    }
}
