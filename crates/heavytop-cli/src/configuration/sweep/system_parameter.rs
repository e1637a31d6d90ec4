//! The numbers of `[system]` that a sweep may vary.

use crate::vocabulary::brief::text;
use std::fmt;

/// A number of `[system]`: `system.parameters.k`, `system.parameters.I[0]`, `system.initial.Pi[0]`,
/// `system.initial.Pi1`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SystemParameter {
    /// The table of the number.
    pub table: SystemTable,
    /// The key of a number or a vector of the table.
    pub name: String,
    /// The index of the number in the vector, from 0.
    pub index: Option<usize>,
}

/// A table of `[system]` whose numbers a sweep may vary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SystemTable {
    /// `[system.parameters]`: numbers in the Hamiltonian and the brackets.
    Parameters,
    /// `[system.initial]`: coordinates of the initial state.
    Initial,
}

impl SystemTable {
    const fn name(self) -> &'static str {
        match self {
            Self::Parameters => "parameters",
            Self::Initial => "initial",
        }
    }
}

impl SystemParameter {
    /// Reads the path of a number below `[system]`.
    ///
    /// # Errors
    /// Returns a message with the paths that there are.
    pub(super) fn of_path(path: &str) -> Result<Self, String> {
        let unknown = || {
            format!(
                "unknown parameter `system.{}`; a system has system.parameters.NAME and system.initial.NAME, with an \
                 index behind a vector, as in system.initial.Pi[0]",
                text(path)
            )
        };
        let (table, path) = path.split_once('.').ok_or_else(unknown)?;
        let tables = [SystemTable::Parameters, SystemTable::Initial];
        let table = tables.into_iter().find(|known| known.name() == table).ok_or_else(unknown)?;
        let (name, index) = match path.strip_suffix(']') {
            Some(path) => {
                let (name, index) = path.split_once('[').ok_or_else(unknown)?;
                (name, Some(index.parse().map_err(|_| unknown())?))
            }
            None => (path, None),
        };
        if name.is_empty() || name.contains(['.', '[']) {
            return Err(unknown());
        }
        Ok(Self { table, name: name.into(), index })
    }
}

/// Writes the path in the configuration.
impl fmt::Display for SystemParameter {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "system.{}.{}", self.table.name(), self.name)?;
        self.index.map_or(Ok(()), |index| write!(to, "[{index}]"))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn paths_read_back_as_they_are_written() {
        for path in ["parameters.k", "parameters.I[0]", "initial.Π₁", "initial.Pi[12]"] {
            assert_eq!(
                SystemParameter::of_path(path).unwrap().to_string(),
                format!("system.{path}")
            );
        }
        for path in [
            "parameters",
            "parameters.",
            "parameters.a.b",
            "parameters.I[",
            "parameters.I]",
            "parameters.I[-1]",
            "parameters.I[0][1]",
            "parameters.[0]",
            "initial.Pi[x]",
            "hamiltonian",
            "brackets.K",
        ] {
            assert!(SystemParameter::of_path(path).unwrap_err().contains(path), "{path}");
        }
    }
}
