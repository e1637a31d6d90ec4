//! A table of `[inputs]`: [`InputConfig`].

use lie_poisson::{InputTable, InputTableError, Interpolation};
use serde::{Deserialize, Serialize};

/// An input by a table of times and values, whose name formulas may use.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct InputConfig {
    /// The times, s, which increase.
    pub times: Vec<f64>,
    /// The values at these times.
    pub values: Vec<f64>,
    /// How the input goes on between the times.
    pub interpolation: Between,
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
    pub(super) fn table(&self) -> Result<InputTable, InputTableError> {
        let interpolation = match self.interpolation {
            Between::Constant => Interpolation::Constant,
            Between::Linear => Interpolation::Linear,
            Between::Cubic => Interpolation::Cubic,
        };
        InputTable::new(self.times.clone(), self.values.clone(), interpolation)
    }
}
