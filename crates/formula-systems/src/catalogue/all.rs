//! The list of all systems by name.

use super::bodies::{
    body_in_fluid::BODY_IN_FLUID, body_with_rotors::BODY_WITH_ROTORS, gyrostat::GYROSTAT,
    reaction_wheels::REACTION_WHEELS, rigid_body::RIGID_BODY, satellite::SATELLITE,
    top_on_base::TOP_ON_BASE,
};
use super::fluids_and_spins::{
    elliptical_vortex::ELLIPTICAL_VORTEX, spin_chain::SPIN_CHAIN, vortices::VORTICES,
};
use super::system_kind::SystemKind;
use crate::error::FormulaSystemError;

impl SystemKind {
    /// All systems by name.
    pub const ALL: &[Self] = &[
        BODY_IN_FLUID,
        BODY_WITH_ROTORS,
        ELLIPTICAL_VORTEX,
        GYROSTAT,
        REACTION_WHEELS,
        RIGID_BODY,
        SATELLITE,
        SPIN_CHAIN,
        TOP_ON_BASE,
        VORTICES,
    ];

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
