//! Configurations to begin with, which `init` writes.

pub(super) mod first_configuration;
pub(super) mod first_system;
pub(super) mod map_tables;
