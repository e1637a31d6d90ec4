//! A table of `[inputs]`: [`InputConfig`].

use crate::errors::{Error, SystemTableError};
use lie_poisson::{InputTable, Interpolation};
use lie_poisson_formula_systems::OpenSystemError;
use serde::{Deserialize, Serialize};

/// An input by a table of times and values, whose name formulas may use.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct InputConfig {
    /// The times, s, which increase.
    pub times: Vec<f64>,
    /// The values at these times.
    pub values: Vec<f64>,
    /// How the input goes on between the times.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interpolation: Option<Between>,
}

/// How an input goes on between its times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Between {
    /// Each value holds until the next time.
    Constant,
    /// Straight lines.
    Linear,
    /// The natural cubic spline.
    Cubic,
}

impl InputConfig {
    /// Returns the table.
    ///
    /// # Errors
    /// If the times do not increase, there are not as many values, or a number is not finite.
    pub(super) fn table(&self, name: &str) -> Result<InputTable, Error> {
        let missing = |key| SystemTableError::MissingKey { table: format!("inputs.{name}"), key };
        let interpolation = match self.interpolation {
            Some(Between::Constant) => Interpolation::Constant,
            Some(Between::Linear) => Interpolation::Linear,
            Some(Between::Cubic) => Interpolation::Cubic,
            None => return Err(missing("interpolation, constant, linear or cubic,").into()),
        };
        if self.times.is_empty() {
            return Err(missing("times").into());
        }
        let refused = |reason| OpenSystemError::Input { name: name.into(), reason };
        Ok(InputTable::new(self.times.clone(), self.values.clone(), interpolation)
            .map_err(refused)?)
    }
}
