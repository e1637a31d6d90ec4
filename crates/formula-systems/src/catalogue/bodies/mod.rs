//! Rigid bodies by name.

pub(super) mod body_in_fluid;
pub(super) mod body_with_rotors;
pub(super) mod gyrostat;
pub(super) mod reaction_wheels;
pub(super) mod rigid_body;
pub(super) mod satellite;
pub(super) mod top_on_base;
mod wheels;
