//! The table `[integrator]`: the method and its steps.

use crate::vocabulary::method_names;
use heavytop::methods::{Formulation, Scheme};
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
    pub scheme: Option<Scheme>,
    /// The time step, s.
    pub step: Option<f64>,
    /// The time to stop at, s: a whole number of steps.
    pub end: Option<f64>,
    /// The tolerance of the stage equations; 0 iterates to the round-off floor.
    pub tolerance: Option<f64>,
}

/// An integrator with no key left out; the default is that of `simulate`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integration {
    /// The formulation: where the scheme is applied.
    pub formulation: Formulation,
    /// The one-step scheme.
    pub scheme: Scheme,
    /// The time step, s.
    pub step: f64,
    /// The time to stop at, s.
    pub end: f64,
    /// The tolerance of the stage equations.
    pub tolerance: f64,
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

impl IntegratorConfig {
    /// Returns the integrator of these keys, with the values of `own` where a key is missing.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::configuration::{Integration, IntegratorConfig};
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
