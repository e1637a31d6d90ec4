//! The table `[initial]`: the state from which a top starts.

use super::angle::{AZIMUTH, INCLINATION, azimuth, inclination};
use super::body_config::BodyConfig;
use super::directions::{scaled, unit_vector};
use crate::errors::Error;
use heavytop::require_unit;
use lie_poisson::Se3Dual;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// The table `[initial]`: the state at t = 0, in the body frame.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "InitialKeys", into = "InitialKeys")]
pub struct InitialConfig {
    /// The angular momentum Π(0), kg m²/s; it plays no part where there is an angular velocity.
    pub angular_momentum: [f64; 3],
    /// The angular velocity Ω(0), rad/s, for Π(0) = I Ω(0).
    pub angular_velocity: Option<[f64; 3]>,
    /// The vertical direction Γ(0), a unit vector; it plays no part where there is an inclination.
    pub vertical: [f64; 3],
    /// The inclination i of Γ(0) = (sin i cos a, sin i sin a, cos i), in radians from 0 to π.
    pub inclination: Option<f64>,
    /// The azimuth a beside the inclination, in radians between −2π and 2π; 0 by default.
    pub azimuth: Option<f64>,
    /// Whether `vertical` is scaled to length 1, instead of being refused if it has another length.
    pub normalise: bool,
}

/// The keys of `[initial]`.
#[derive(Default, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
struct InitialKeys {
    angular_momentum: Option<[f64; 3]>,
    angular_velocity: Option<[f64; 3]>,
    vertical: Option<[f64; 3]>,
    #[serde(deserialize_with = "inclination")]
    inclination: Option<f64>,
    #[serde(deserialize_with = "azimuth")]
    azimuth: Option<f64>,
    #[serde(skip_serializing_if = "is_false")]
    normalise: bool,
}

fn is_false(value: &bool) -> bool {
    !value
}

impl Default for InitialConfig {
    fn default() -> Self {
        Self {
            angular_momentum: [2.0, 3.0, 4.0],
            angular_velocity: None,
            vertical: [0.5, 0.0, 0.75_f64.sqrt()],
            inclination: None,
            azimuth: None,
            normalise: false,
        }
    }
}

/// The message begins with the key that is at fault, and ends with what to write.
impl TryFrom<InitialKeys> for InitialConfig {
    type Error = &'static str;

    fn try_from(keys: InitialKeys) -> Result<Self, &'static str> {
        let own = Self::default();
        if keys.angular_momentum.is_some() && keys.angular_velocity.is_some() {
            return Err("`angular_velocity` excludes `angular_momentum`; write one of them");
        }
        if keys.vertical.is_some() && keys.inclination.is_some() {
            return Err("`inclination` excludes `vertical`; write one of them");
        }
        Ok(Self {
            angular_momentum: keys.angular_momentum.unwrap_or(own.angular_momentum),
            angular_velocity: keys.angular_velocity,
            vertical: keys.vertical.unwrap_or(own.vertical),
            inclination: keys.inclination,
            azimuth: keys.azimuth,
            normalise: keys.normalise,
        })
    }
}

impl From<InitialConfig> for InitialKeys {
    fn from(initial: InitialConfig) -> Self {
        let InitialConfig { angular_momentum, angular_velocity, vertical, .. } = initial;
        let InitialConfig { inclination, azimuth, normalise, .. } = initial;
        Self {
            angular_momentum: angular_velocity.is_none().then_some(angular_momentum),
            angular_velocity,
            vertical: inclination.is_none().then_some(vertical),
            inclination,
            azimuth,
            normalise,
        }
    }
}

impl InitialConfig {
    /// Returns Γ(0), which is no unit vector if the configuration has none.
    #[must_use]
    pub fn direction(&self) -> [f64; 3] {
        match self.inclination {
            Some(inclination) => unit_vector(inclination, self.azimuth.unwrap_or(0.0)),
            None => scaled(self.vertical, self.normalise),
        }
    }

    /// Returns the state (Π(0), Γ(0)) of a body, in the axes of the tables.
    ///
    /// # Errors
    /// If Π is not finite, Γ is no unit vector, an angle is outside its range, or there is an azimuth without an
    /// inclination.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::configuration::{BodyConfig, InitialConfig};
    /// let spin = Some([0.0, 0.0, 50.0]);
    /// let upright = InitialConfig { angular_velocity: spin, inclination: Some(0.0), ..Default::default() };
    /// let body = BodyConfig { inertia: [2.0, 2.0, 0.5].into(), ..BodyConfig::default() };
    /// let start = upright.start(&body)?;
    /// assert_eq!((start.0.0.z, start.0.1.z), (25.0, 1.0));
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn start(&self, body: &BodyConfig) -> Result<Se3Dual, Error> {
        let finite = |name, numbers: &[f64]| match numbers.iter().find(|x| !x.is_finite()) {
            Some(&value) => Err(Error::OutOfRange { name, range: "finite", value }),
            None => Ok(()),
        };
        if self.azimuth.is_some() && self.inclination.is_none() {
            return Err(Error::AzimuthAlone);
        }
        for (name, limits, angle) in [
            ("initial.inclination", INCLINATION, self.inclination),
            ("initial.azimuth", AZIMUTH, self.azimuth),
        ] {
            if let Some(value) = angle.filter(|angle| !limits.contains(*angle)) {
                return Err(Error::OutOfRange { name, range: limits.range, value });
            }
        }
        let vertical = Vector3::from(self.direction());
        require_unit("vertical", &vertical).map_err(Error::Vertical)?;
        let (name, momentum) = match self.angular_velocity {
            Some(velocity) => ("initial.angular_velocity", body.angular_momentum(velocity)),
            None => ("initial.angular_momentum", self.angular_momentum),
        };
        finite(name, &momentum)?;
        Ok(Se3Dual::new(momentum.into(), vertical))
    }
}
