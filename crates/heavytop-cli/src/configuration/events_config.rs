//! The table `[events]`: whose zeros are found along a run.

use super::section_config::{direction, direction_name};
use collective_integrators::Direction;
use serde::{Deserialize, Serialize};

/// The table `[events]`: whose zeros are found along a run.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct EventsConfig {
    /// The functions whose zeros are found: formulas in the coordinates, the time `t` and inputs.
    pub functions: Vec<String>,
    /// The direction in which they pass zero.
    #[serde(deserialize_with = "direction", serialize_with = "direction_name")]
    pub direction: Direction,
    /// The number of zeros of one function after which the run ends; without it, it goes on to its end.
    pub terminal: Option<u64>,
}

impl Default for EventsConfig {
    fn default() -> Self {
        Self { functions: Vec::new(), direction: Direction::Both, terminal: None }
    }
}
