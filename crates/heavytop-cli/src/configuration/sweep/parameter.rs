//! The numbers that an axis of a sweep may vary.

use super::force_parameter::ForceParameter;
use super::system_parameter::SystemParameter;
use super::top_parameter::TopParameter;
use serde::{Deserialize, Serialize};

/// A number that an axis of a sweep varies, named by its path in the configuration.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(try_from = "String", into = "String")]
pub enum Parameter {
    /// A number of `[body]` or `[initial]`.
    Top(TopParameter),
    /// A number of `[system]`.
    System(SystemParameter),
    /// A number of `[damping]`, `[noise]` or `[inputs]`.
    Force(ForceParameter),
}

impl Parameter {
    /// Returns the path in the configuration, which is also the name of the column.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Top(parameter) => parameter.name().into(),
            Self::System(parameter) => parameter.to_string(),
            Self::Force(parameter) => parameter.to_string(),
        }
    }

    /// Returns the words for what has such numbers.
    pub(crate) const fn table(&self) -> &'static str {
        match self {
            Self::Top(_) => "a top",
            Self::System(_) => "[system]",
            Self::Force(_) => "[damping], [noise] or [inputs]",
        }
    }
}

impl From<Parameter> for String {
    fn from(parameter: Parameter) -> Self {
        parameter.name()
    }
}

impl TryFrom<String> for Parameter {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        if let Some(parameter) = ForceParameter::of_path(&name) {
            return parameter.map(Self::Force);
        }
        match name.strip_prefix("system.") {
            Some(path) => SystemParameter::of_path(path).map(Self::System),
            None => TopParameter::by_name(&name).map(Self::Top),
        }
    }
}
