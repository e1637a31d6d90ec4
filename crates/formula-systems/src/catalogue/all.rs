//! The list of all systems by name.

use super::body_with_rotors::BODY_WITH_ROTORS;
use super::system_kind::SystemKind;
use crate::error::FormulaSystemError;

impl SystemKind {
    /// All systems by name.
    pub const ALL: &[Self] = &[BODY_WITH_ROTORS];

    /// Returns the system of this name.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoKind`] with the names that there are.
    pub fn named(name: &str) -> Result<&'static Self, FormulaSystemError> {
        Self::ALL.iter().find(|kind| kind.name == name).ok_or_else(|| FormulaSystemError::NoKind {
            name: name.to_owned(),
            kinds: Self::ALL.iter().map(|kind| format!("{} ({})", kind.name, kind.about)).collect(),
        })
    }
}
