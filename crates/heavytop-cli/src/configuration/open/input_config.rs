//! A table of `[inputs]`: [`InputConfig`].

use crate::errors::{Error, InputFileError, SystemTableError};
use lie_poisson::{InputTable, Interpolation};
use lie_poisson_formula_systems::OpenSystemError;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// An input by a table of times and values, whose name formulas may use.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct InputConfig {
    /// The times, s, which increase.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub times: Vec<f64>,
    /// The values at these times.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub values: Vec<f64>,
    /// The file with the times and the values, instead of both: text with cells between commas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The name of the column of the times in the file; the first one, if it is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time: Option<String>,
    /// The name of the column of the values; the first one but that of the times, if it is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
    /// The checksum of that file, which the program notes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub checksum: Option<u32>,
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
    /// If the times do not increase, there are not as many values, a number is not finite, or the file has no such table.
    pub(super) fn table(&self, name: &str) -> Result<InputTable, Error> {
        let missing = |key| SystemTableError::MissingKey { table: format!("inputs.{name}"), key };
        let interpolation = match self.interpolation {
            Some(Between::Constant) => Interpolation::Constant,
            Some(Between::Linear) => Interpolation::Linear,
            Some(Between::Cubic) => Interpolation::Cubic,
            None => return Err(missing("interpolation, constant, linear or cubic,").into()),
        };
        if let Some(file) = &self.file {
            if !(self.times.is_empty() && self.values.is_empty()) {
                return Err(SystemTableError::TwoTables { input: name.into() }.into());
            }
            let path = Path::new(file);
            let table = self
                .columns(path)
                .and_then(|(times, values)| Ok(InputTable::new(times, values, interpolation)?));
            return table.map_err(|error| failed(name, path, error));
        }
        if self.time.is_some() || self.value.is_some() {
            return Err(missing("file").into());
        }
        if self.times.is_empty() {
            return Err(missing("times").into());
        }
        let refused = |reason| OpenSystemError::Input { name: name.into(), reason };
        Ok(InputTable::new(self.times.clone(), self.values.clone(), interpolation)
            .map_err(refused)?)
    }
}

/// Returns the error of the file of an input.
pub(super) fn failed(name: &str, path: &Path, source: InputFileError) -> Error {
    Error::InputFile { name: name.into(), path: path.into(), source: Box::new(source) }
}
