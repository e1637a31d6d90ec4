//! The table `[section]`: which Poincaré section, and how many points.

use crate::vocabulary::named::{by_name, name_of};
use collective_integrators::Direction;
use heavytop::Coordinate;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The table `[section]`: which Poincaré section, and how many points.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SectionConfig {
    /// The energy h, J; by default that of `[initial]`.
    pub energy: Option<f64>,
    /// The vertical momentum Π·Γ, kg m²/s; by default that of `[initial]`.
    pub vertical_momentum: Option<f64>,
    /// The coordinate that the surface fixes.
    #[serde(deserialize_with = "surface", serialize_with = "surface_name")]
    pub surface: Coordinate,
    /// The value of that coordinate on the surface.
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
}

impl Default for SectionConfig {
    fn default() -> Self {
        Self {
            energy: None,
            vertical_momentum: None,
            surface: Coordinate::Gamma3,
            level: 0.0,
            direction: Direction::Up,
            starts: 60,
            crossings: 500,
            longest: 10_000.0,
            seed: 0,
        }
    }
}

fn surface<'de, D: Deserializer<'de>>(from: D) -> Result<Coordinate, D::Error> {
    let names = Coordinate::ALL.map(|coordinate| (coordinate.name(), coordinate));
    by_name("surface", &names, &String::deserialize(from)?).map_err(D::Error::custom)
}

fn surface_name<S: Serializer>(surface: &Coordinate, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(surface.name())
}

const DIRECTIONS: &[(&str, Direction)] =
    &[("up", Direction::Up), ("down", Direction::Down), ("both", Direction::Both)];

fn direction<'de, D: Deserializer<'de>>(from: D) -> Result<Direction, D::Error> {
    by_name("direction", DIRECTIONS, &String::deserialize(from)?).map_err(D::Error::custom)
}

fn direction_name<S: Serializer>(direction: &Direction, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(name_of(DIRECTIONS, *direction))
}
