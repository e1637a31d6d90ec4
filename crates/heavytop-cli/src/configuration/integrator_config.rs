//! The table `[integrator]`: the method and its steps.

use crate::errors::Error;
use crate::vocabulary::method_names;
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson::InstructionSet;
use serde::{Deserialize, Serialize};

/// The table `[integrator]`: the method and its steps. The defaults of its keys depend on the command.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct IntegratorConfig {
    /// The formulation: where the scheme is applied.
    #[serde(with = "method_names")]
    pub formulation: Option<Formulation>,
    /// The scheme's name in configurations.
    #[serde(with = "method_names")]
    pub scheme: Option<SchemeName>,
    /// The time step, s.
    pub step: Option<f64>,
    /// The time to stop at, s: a whole number of steps, backward in time to an end before 0.
    pub end: Option<f64>,
    /// The tolerance of the stage equations; 0 iterates to the round-off floor.
    pub tolerance: Option<f64>,
    /// The instructions of the processor that are used.
    pub instructions: Option<Instructions>,
}

/// The instructions of the processor that a run uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Instructions {
    /// The fastest instructions that this processor has. Other processors may give other last digits.
    #[default]
    Native,
    /// The instructions that every processor has. A run has the same bits on each processor.
    Portable,
}

/// An integrator with no key left out; the default is that of `simulate`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integration {
    /// The formulation: where the scheme is applied.
    pub formulation: Formulation,
    /// The one-step scheme.
    pub scheme: SchemeName,
    /// The time step, s.
    pub step: f64,
    /// The time to stop at, s.
    pub end: f64,
    /// The tolerance of the stage equations.
    pub tolerance: f64,
    /// The instructions of the processor that are used.
    pub instructions: Instructions,
}

impl Integration {
    /// Returns the method for tops.
    ///
    /// # Errors
    /// If there is no such method.
    pub fn method(&self) -> Result<Method, Error> {
        let method = Method::new(self.formulation, self.scheme, self.tolerance)?;
        match self.instructions {
            Instructions::Native => Ok(method),
            Instructions::Portable => {
                let method = method.with_instructions(InstructionSet::Portable);
                method.map_err(|error| Error::Method(error.into()))
            }
        }
    }
}

impl Default for Integration {
    fn default() -> Self {
        Self {
            formulation: Formulation::default(),
            scheme: SchemeName::default(),
            step: 0.02,
            end: 100.0,
            tolerance: 0.0,
            instructions: Instructions::default(),
        }
    }
}

impl IntegratorConfig {
    /// Returns the integrator of these keys, with the values of `own` where a key is missing. With a negative step, an end
    /// that is missing is before 0.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::configuration::{Integration, IntegratorConfig};
    /// let keys = IntegratorConfig { end: Some(7.0), ..IntegratorConfig::default() };
    /// let own = Integration { step: 0.1, ..Integration::default() };
    /// assert_eq!(keys.or(own), Integration { end: 7.0, ..own });
    /// let backward = IntegratorConfig { step: Some(-0.1), ..IntegratorConfig::default() };
    /// assert_eq!(backward.or(own).end, -own.end);
    /// ```
    #[must_use]
    pub fn or(self, own: Integration) -> Integration {
        let step = self.step.unwrap_or(own.step);
        Integration {
            formulation: self.formulation.unwrap_or(own.formulation),
            scheme: self.scheme.unwrap_or(own.scheme),
            step,
            end: self.end.unwrap_or(own.end.copysign(step)),
            tolerance: self.tolerance.unwrap_or(own.tolerance),
            instructions: self.instructions.unwrap_or(own.instructions),
        }
    }
}

impl From<Integration> for IntegratorConfig {
    /// Names all keys, except `instructions` if they are the usual ones.
    fn from(all: Integration) -> Self {
        let instructions = Some(all.instructions).filter(|set| *set != Instructions::default());
        Self {
            formulation: Some(all.formulation),
            scheme: Some(all.scheme),
            step: Some(all.step),
            end: Some(all.end),
            tolerance: Some(all.tolerance),
            instructions,
        }
    }
}
