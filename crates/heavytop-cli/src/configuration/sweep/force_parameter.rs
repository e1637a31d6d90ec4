//! The numbers of the tables of forces that a sweep may vary.

use crate::vocabulary::brief::text;
use std::fmt;

/// A number of `[damping]`, `[noise]` or `[inputs]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ForceParameter {
    /// The friction θ, `damping.friction`.
    Friction,
    /// The temperature kT, `noise.temperature`.
    Temperature,
    /// The strength σ, `noise.strength`.
    Strength,
    /// A value of the table of an input, `inputs.NAME.values[i]`.
    InputValue {
        /// The name of the input.
        input: String,
        /// The index of the value, from 0.
        index: usize,
    },
}

impl ForceParameter {
    /// Reads the path of a number of a table of forces; `None` if it is a path of another table.
    pub(super) fn of_path(path: &str) -> Option<Result<Self, String>> {
        let (table, rest) = path.split_once('.')?;
        if !["damping", "noise", "inputs"].contains(&table) {
            return None;
        }
        let found = match path {
            "damping.friction" => Some(Self::Friction),
            "noise.temperature" => Some(Self::Temperature),
            "noise.strength" => Some(Self::Strength),
            _ if table == "inputs" => Self::value_of_input(rest),
            _ => None,
        };
        Some(found.ok_or_else(|| {
            format!(
                "unknown parameter `{}`; forces have damping.friction, noise.temperature, noise.strength and \
                 inputs.NAME.values[i]",
                text(path)
            )
        }))
    }

    /// Returns whether the number is at least 0 in every motion.
    pub(super) const fn is_never_negative(&self) -> bool {
        !matches!(self, Self::InputValue { .. })
    }

    /// Reads `NAME.values[i]`.
    fn value_of_input(path: &str) -> Option<Self> {
        let (input, index) = path.strip_suffix(']')?.rsplit_once(".values[")?;
        let index = index.parse().ok()?;
        (!input.is_empty()).then(|| Self::InputValue { input: input.into(), index })
    }
}

/// Writes the path in the configuration.
impl fmt::Display for ForceParameter {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Friction => to.write_str("damping.friction"),
            Self::Temperature => to.write_str("noise.temperature"),
            Self::Strength => to.write_str("noise.strength"),
            Self::InputValue { input, index } => write!(to, "inputs.{input}.values[{index}]"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_read_back_as_they_are_written() {
        let paths =
            ["damping.friction", "noise.temperature", "noise.strength", "inputs.u.values[2]"];
        for path in paths {
            let read = ForceParameter::of_path(path).map(|read| read.map(|read| read.to_string()));
            assert_eq!(read, Some(Ok(path.into())));
        }
        for path in
            ["damping.form", "noise.seed", "inputs.u", "inputs.values[1]", "inputs.u.values[x]"]
        {
            assert!(ForceParameter::of_path(path).is_some_and(|read| read.is_err()), "{path}");
        }
        assert_eq!(ForceParameter::of_path("body.mass"), None);
    }
}
