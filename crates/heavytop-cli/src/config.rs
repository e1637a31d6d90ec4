//! The configuration file.

use crate::Error;
use crate::integrators::Method;
use crate::method::{Formulation, Scheme};
use crate::run::Experiment;
use crate::schedule::Schedule;
use crate::section::SectionConfig;
use crate::sweep::SweepConfig;
use heavytop::{Body, HeavyTop, require_unit};
use lie_poisson::Se3Dual;
use nalgebra::Vector3;
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

/// `[body]`: the parameters of the top.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct BodyConfig {
    /// Principal moments, kg m².
    pub inertia: [f64; 3],
    /// Mass, kg.
    pub mass: f64,
    /// Gravity, m/s²; 0 gives the free rigid body.
    pub gravity: f64,
    /// From the support to the centre of mass, m.
    pub length: f64,
    /// The direction from the support to the centre of mass in the body frame, a unit vector.
    pub center_of_mass: [f64; 3],
}

/// `[initial]`: the state at t = 0, in the body frame.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct InitialConfig {
    /// Π(0), kg m²/s.
    pub angular_momentum: [f64; 3],
    /// Γ(0), a unit vector.
    pub vertical: [f64; 3],
}

/// `[integrator]`: the method and its steps. What a key does not say depends on the command.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct IntegratorConfig {
    /// Where the scheme is applied.
    pub formulation: Option<Formulation>,
    /// The scheme.
    pub scheme: Option<Scheme>,
    /// The time step, s.
    pub step: Option<f64>,
    /// The time to stop at, s: a whole number of steps.
    pub end: Option<f64>,
    /// For the stage equations; 0 iterates to the round-off floor.
    pub tolerance: Option<f64>,
}

/// An integrator in which nothing is left out; by default that of `simulate`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integration {
    /// Where the scheme is applied.
    pub formulation: Formulation,
    /// The scheme.
    pub scheme: Scheme,
    /// The time step, s.
    pub step: f64,
    /// The time to stop at, s.
    pub end: f64,
    /// For the stage equations.
    pub tolerance: f64,
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

impl Default for BodyConfig {
    fn default() -> Self {
        Self {
            inertia: [2.0, 2.0, 1.0],
            mass: 1.0,
            gravity: 1.0,
            length: 1.0,
            center_of_mass: [1.0, 0.0, 0.0],
        }
    }
}

impl Default for InitialConfig {
    fn default() -> Self {
        Self { angular_momentum: [2.0, 3.0, 4.0], vertical: [0.5, 0.0, 0.75_f64.sqrt()] }
    }
}

impl Default for Integration {
    fn default() -> Self {
        Self {
            formulation: Formulation::default(),
            scheme: Scheme::default(),
            step: 0.02,
            end: 100.0,
            tolerance: 0.0,
        }
    }
}

impl Default for OutputConfig {
    fn default() -> Self {
        Self { every: 1, attitude: false }
    }
}

impl IntegratorConfig {
    /// The integrator of these keys, and of a command's own where there is none.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::config::{Integration, IntegratorConfig};
    /// let keys = IntegratorConfig { end: Some(7.0), ..IntegratorConfig::default() };
    /// let own = Integration { step: 0.1, ..Integration::default() };
    /// assert_eq!(keys.or(own), Integration { end: 7.0, ..own });
    /// ```
    #[must_use]
    pub fn or(self, own: Integration) -> Integration {
        Integration {
            formulation: self.formulation.unwrap_or(own.formulation),
            scheme: self.scheme.unwrap_or(own.scheme),
            step: self.step.unwrap_or(own.step),
            end: self.end.unwrap_or(own.end),
            tolerance: self.tolerance.unwrap_or(own.tolerance),
        }
    }
}

impl From<Integration> for IntegratorConfig {
    fn from(all: Integration) -> Self {
        Self {
            formulation: Some(all.formulation),
            scheme: Some(all.scheme),
            step: Some(all.step),
            end: Some(all.end),
            tolerance: Some(all.tolerance),
        }
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
    /// If there is no such top.
    pub fn top(&self) -> Result<HeavyTop, Error> {
        let BodyConfig { inertia, mass, gravity, length, center_of_mass } = self.body;
        let (inertia, center_of_mass) = (inertia.into(), center_of_mass.into());
        HeavyTop::new(&Body { inertia, mass, gravity, length, center_of_mass }).map_err(Error::Body)
    }

    /// The state of `[initial]`.
    ///
    /// # Errors
    /// If Π is not finite or Γ is no unit vector.
    pub fn start(&self) -> Result<Se3Dual, Error> {
        let InitialConfig { angular_momentum, vertical } = self.initial;
        let vertical = Vector3::from(vertical);
        require_unit("vertical", &vertical).map_err(Error::Vertical)?;
        if let Some(&value) = angular_momentum.iter().find(|x| !x.is_finite()) {
            return Err(Error::OutOfRange { name: "angular_momentum", range: "finite", value });
        }
        Ok(Se3Dual::new(angular_momentum.into(), vertical))
    }
}

/// The most that a body may turn in one step, rad: sixteen times around.
pub(crate) const MOST_TURN: f64 = 100.0;

/// Checks that h (|Ω(0)| + √(m g l/I)), I the least moment, is an angle that a step may have.
pub(crate) fn require_sane_step(top: &HeavyTop, start: &Se3Dual, step: f64) -> Result<(), Error> {
    let spin = top.angular_velocity(&start.0.0).norm();
    let angle = step * (spin + (top.weight_moment() / top.inertia().min()).sqrt());
    if angle <= MOST_TURN || step <= 0.0 || step.is_nan() {
        Ok(())
    } else {
        Err(Error::AbsurdStep { step, angle, most: MOST_TURN })
    }
}
