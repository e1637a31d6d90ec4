//! Configurations to begin with, which `init` writes.

pub(super) mod first_configuration;
mod first_forces;
pub(super) mod first_system;
pub(super) mod map_tables;
