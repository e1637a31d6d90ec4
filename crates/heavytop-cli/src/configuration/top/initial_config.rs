//! The table `[initial]`: the state from which a top starts.

use super::angle::{AZIMUTH, INCLINATION, azimuth, euler_angles, inclination};
use super::body_config::BodyConfig;
use super::directions::{scaled, unit_vector};
use crate::errors::Error;
use heavytop::{EulerAngles, TopError, UNIT_TOLERANCE, require_unit};
use lie_poisson::{Quaternion, Se3Dual, Vector};
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
    /// The vertical direction Γ(0), a unit vector; it plays no part where there is an inclination or an attitude.
    pub vertical: [f64; 3],
    /// The inclination i of Γ(0) = (sin i cos a, sin i sin a, cos i), in radians from 0 to π.
    pub inclination: Option<f64>,
    /// The azimuth a beside the inclination, in radians between −2π and 2π; 0 by default.
    pub azimuth: Option<f64>,
    /// The attitude at the start, a unit quaternion (w, x, y, z) that rotates the body frame to the spatial frame, from which
    /// Γ(0) follows.
    pub attitude: Option<[f64; 4]>,
    /// The Euler angles (φ, θ, ψ) of the attitude at the start, rad, by [`EulerAngles`].
    pub euler_angles: Option<[f64; 3]>,
    /// Whether `vertical` and `attitude` are scaled to length 1, instead of being refused if they have another length.
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
    attitude: Option<[f64; 4]>,
    #[serde(deserialize_with = "euler_angles")]
    euler_angles: Option<[f64; 3]>,
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
            attitude: None,
            euler_angles: None,
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
        let has_angles = keys.inclination.is_some() || keys.azimuth.is_some();
        if keys.attitude.is_some() && keys.euler_angles.is_some() {
            return Err("`euler_angles` excludes `attitude`; write one of them");
        }
        if keys.attitude.is_some() && (keys.vertical.is_some() || has_angles) {
            return Err("`attitude` gives the vertical; write it alone");
        }
        if keys.euler_angles.is_some() && (keys.vertical.is_some() || has_angles) {
            return Err("`euler_angles` give the vertical; write them alone");
        }
        Ok(Self {
            angular_momentum: keys.angular_momentum.unwrap_or(own.angular_momentum),
            angular_velocity: keys.angular_velocity,
            vertical: keys.vertical.unwrap_or(own.vertical),
            inclination: keys.inclination,
            azimuth: keys.azimuth,
            attitude: keys.attitude,
            euler_angles: keys.euler_angles,
            normalise: keys.normalise,
        })
    }
}

impl From<InitialConfig> for InitialKeys {
    fn from(initial: InitialConfig) -> Self {
        let InitialConfig { angular_momentum, angular_velocity, vertical, .. } = initial;
        let InitialConfig { inclination, azimuth, attitude, euler_angles, normalise, .. } = initial;
        let is_vertical = inclination.is_none() && attitude.is_none() && euler_angles.is_none();
        Self {
            angular_momentum: angular_velocity.is_none().then_some(angular_momentum),
            angular_velocity,
            vertical: is_vertical.then_some(vertical),
            inclination,
            azimuth,
            attitude,
            euler_angles,
            normalise,
        }
    }
}

impl InitialConfig {
    /// Returns Γ(0), which is no unit vector if the configuration has none.
    #[must_use]
    pub fn direction(&self) -> [f64; 3] {
        if let Some(attitude) = self.given_attitude() {
            return attitude.conjugate().rotate(&Vector3::z()).into();
        }
        match self.inclination {
            Some(inclination) => unit_vector(inclination, self.azimuth.unwrap_or(0.0)),
            None => scaled(self.vertical, self.normalise),
        }
    }

    /// Returns the attitude at the start, if the configuration gives one.
    ///
    /// # Errors
    /// If its quaternion is no unit quaternion, or an angle is not finite.
    pub fn attitude(&self) -> Result<Option<Quaternion>, Error> {
        let Some(attitude) = self.given_attitude() else { return Ok(None) };
        let length = attitude.norm_squared().sqrt();
        match (length - 1.0).abs() <= UNIT_TOLERANCE {
            true => Ok(Some(attitude)),
            false => {
                let (name, tolerance) = ("attitude", UNIT_TOLERANCE);
                Err(Error::Vertical(TopError::NotUnit { name, length, tolerance }))
            }
        }
    }

    /// Returns the quaternion of the attitude, which is no unit quaternion if the configuration has none.
    fn given_attitude(&self) -> Option<Quaternion> {
        if let Some([precession, nutation, spin]) = self.euler_angles {
            return Some(EulerAngles { precession, nutation, spin }.attitude());
        }
        let given = self.attitude?;
        let largest = given.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let is_scaled = self.normalise && largest > 0.0 && largest.is_finite();
        let [scalar, x, y, z] = given.map(|x| if is_scaled { x / largest } else { x });
        let attitude = Quaternion { scalar, vector: Vector3::new(x, y, z) };
        let length = if is_scaled { attitude.norm_squared().sqrt() } else { 1.0 };
        Some(attitude.scaled(1.0 / length))
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
        self.attitude()?;
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
