//! The table `[section]`: which Poincaré section, and how many points.

use super::plane_limits::PlaneLimits;
use super::system::Numbers;
use crate::errors::Error;
use crate::vocabulary::named::{by_name, name_of};
use collective_integrators::Direction;
use heavytop::{Coordinate, SurfaceVariable};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeMap;

/// The table `[section]`: which Poincaré section, and how many points.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SectionConfig {
    /// The energy h, J; by default that of the initial state.
    pub energy: Option<f64>,
    /// The vertical momentum Π·Γ of a top, kg m²/s; by default that of `[initial]`.
    pub vertical_momentum: Option<f64>,
    /// The coordinate or the angle that the surface fixes, by default Γ₃ of a top; for a system a formula.
    pub surface: Option<String>,
    /// The value of that coordinate, angle (rad) or formula on the surface.
    pub level: f64,
    /// The direction in which the surface is crossed.
    #[serde(deserialize_with = "direction", serialize_with = "direction_name")]
    pub direction: Direction,
    /// The number of starts.
    pub starts: u32,
    /// The number of returns of each start.
    pub crossings: u32,
    /// The largest time for which a start is followed, s.
    pub longest: f64,
    /// The seed of the random choice of starts.
    pub seed: u64,
    /// The formulas over which the section of a system is drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axes: Option<[String; 2]>,
    /// The initial states of the motions of a system, instead of random starts: values of the coordinates, by name.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub states: Vec<BTreeMap<String, Numbers>>,
    /// The part of the plane that the picture shows; by default that with the points.
    #[serde(skip_serializing_if = "is_default")]
    pub limits: PlaneLimits,
}

impl Default for SectionConfig {
    fn default() -> Self {
        Self {
            energy: None,
            vertical_momentum: None,
            surface: None,
            level: 0.0,
            direction: Direction::Up,
            starts: 60,
            crossings: 500,
            longest: 10_000.0,
            seed: 0,
            axes: None,
            states: Vec::new(),
            limits: PlaneLimits::default(),
        }
    }
}

impl SectionConfig {
    /// Returns the coordinate or the angle that the surface of a top fixes.
    ///
    /// # Errors
    /// If there is none of this name.
    pub(crate) fn variable(&self) -> Result<SurfaceVariable, Error> {
        let surface = self.surface.as_deref().unwrap_or(Coordinate::Gamma3.name());
        let unknown = || {
            let names = SurfaceVariable::ALL.map(|variable| (variable.name(), variable));
            by_name("surface", &names, surface).map_err(Error::UnknownSurface)
        };
        SurfaceVariable::named(surface).map_or_else(unknown, Ok)
    }

    /// Checks that no key is of systems alone.
    ///
    /// # Errors
    /// If there is such a key.
    pub(crate) fn require_top(&self) -> Result<(), Error> {
        match (&self.axes, self.states.as_slice()) {
            (Some(_), _) => Err(Error::SectionKey { key: "axes", of: "[system]" }),
            (None, [_, ..]) => Err(Error::SectionKey { key: "states", of: "[system]" }),
            (None, []) => Ok(()),
        }
    }

    /// Checks that no key is of motions without forces, whose energy is conserved.
    ///
    /// # Errors
    /// If there is such a key.
    pub(crate) fn require_open(&self) -> Result<(), Error> {
        let of = "a motion without forces";
        match (self.energy, self.vertical_momentum) {
            (Some(_), _) => Err(Error::SectionKey { key: "energy", of }),
            (None, Some(_)) => Err(Error::SectionKey { key: "vertical_momentum", of }),
            (None, None) => Ok(()),
        }
    }

    /// Checks that no key is of tops alone.
    ///
    /// # Errors
    /// If there is such a key.
    pub(crate) fn require_system(&self) -> Result<(), Error> {
        match self.vertical_momentum {
            Some(_) => Err(Error::SectionKey { key: "vertical_momentum", of: "a top" }),
            None => Ok(()),
        }
    }
}

fn is_default(limits: &PlaneLimits) -> bool {
    *limits == PlaneLimits::default()
}

const DIRECTIONS: &[(&str, Direction)] =
    &[("up", Direction::Up), ("down", Direction::Down), ("both", Direction::Both)];

pub(super) fn direction<'de, D: Deserializer<'de>>(from: D) -> Result<Direction, D::Error> {
    by_name("direction", DIRECTIONS, &String::deserialize(from)?).map_err(D::Error::custom)
}

pub(super) fn direction_name<S: Serializer>(
    direction: &Direction,
    to: S,
) -> Result<S::Ok, S::Error> {
    to.serialize_str(name_of(DIRECTIONS, *direction))
}
