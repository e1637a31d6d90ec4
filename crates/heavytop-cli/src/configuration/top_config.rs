//! The tables `[body]` and `[initial]`: a top and the state from which it starts.

use crate::Error;
use heavytop::{Body, HeavyTop, require_unit};
use lie_poisson::{Se3Dual, euclidean_norm};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// The table `[body]`: the parameters of the top.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct BodyConfig {
    /// The principal moments of inertia, kg m².
    pub inertia: [f64; 3],
    /// The mass of the top, kg.
    pub mass: f64,
    /// The gravitational acceleration, m/s²; 0 gives the free rigid body.
    pub gravity: f64,
    /// The distance from the support to the centre of mass, m.
    pub length: f64,
    /// The direction from the support to the centre of mass in the body frame, a unit vector.
    pub center_of_mass: [f64; 3],
    /// Whether `center_of_mass` is scaled to length 1, instead of being refused if it has another length.
    #[serde(skip_serializing_if = "is_false")]
    pub normalise: bool,
}

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
    /// The inclination i of Γ(0) = (sin i cos a, sin i sin a, cos i), rad.
    pub inclination: Option<f64>,
    /// The azimuth a beside the inclination, rad; 0 by default.
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
    inclination: Option<f64>,
    azimuth: Option<f64>,
    #[serde(skip_serializing_if = "is_false")]
    normalise: bool,
}

fn is_false(value: &bool) -> bool {
    !value
}

impl Default for BodyConfig {
    fn default() -> Self {
        Self {
            inertia: [2.0, 2.0, 1.0],
            mass: 1.0,
            gravity: 1.0,
            length: 1.0,
            center_of_mass: [1.0, 0.0, 0.0],
            normalise: false,
        }
    }
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

impl BodyConfig {
    /// Returns the direction of the centre of mass, which is no unit vector if the configuration has none.
    #[must_use]
    pub fn center(&self) -> [f64; 3] {
        scaled(self.center_of_mass, self.normalise)
    }

    /// Returns the top with these parameters.
    ///
    /// # Errors
    /// If there is no such top.
    pub fn top(&self) -> Result<HeavyTop, Error> {
        let Self { inertia, mass, gravity, length, .. } = *self;
        let (inertia, center_of_mass) = (inertia.into(), self.center().into());
        HeavyTop::new(&Body { inertia, mass, gravity, length, center_of_mass }).map_err(Error::Body)
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

    /// Returns the state (Π(0), Γ(0)) of a body with these principal moments of inertia (kg m²).
    ///
    /// # Errors
    /// If Π is not finite, Γ is no unit vector, or there is an azimuth without an inclination.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::configuration::InitialConfig;
    /// let spin = Some([0.0, 0.0, 50.0]);
    /// let upright = InitialConfig { angular_velocity: spin, inclination: Some(0.0), ..Default::default() };
    /// let start = upright.start([2.0, 2.0, 0.5])?;
    /// assert_eq!((start.0.0.z, start.0.1.z), (25.0, 1.0));
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn start(&self, inertia: [f64; 3]) -> Result<Se3Dual, Error> {
        let finite = |name, numbers: &[f64]| match numbers.iter().find(|x| !x.is_finite()) {
            Some(&value) => Err(Error::OutOfRange { name, range: "finite", value }),
            None => Ok(()),
        };
        if self.azimuth.is_some() && self.inclination.is_none() {
            return Err(Error::AzimuthAlone);
        }
        finite("inclination", self.inclination.as_slice())?;
        finite("azimuth", self.azimuth.as_slice())?;
        let vertical = Vector3::from(self.direction());
        require_unit("vertical", &vertical).map_err(Error::Vertical)?;
        let (name, momentum) = match self.angular_velocity {
            Some(velocity) => {
                ("angular_velocity", std::array::from_fn(|i| inertia[i] * velocity[i]))
            }
            None => ("angular_momentum", self.angular_momentum),
        };
        finite(name, &momentum)?;
        Ok(Se3Dual::new(momentum.into(), vertical))
    }
}

/// Returns the vector, scaled to length 1 if it shall be.
fn scaled(vector: [f64; 3], normalise: bool) -> [f64; 3] {
    if normalise { normalised(vector) } else { vector }
}

/// Returns the vector, scaled to length 1 if it has a direction.
pub(in crate::configuration) fn normalised(vector: [f64; 3]) -> [f64; 3] {
    let length = euclidean_norm(&Vector3::from(vector));
    if length > 0.0 && length.is_finite() { vector.map(|x| x / length) } else { vector }
}

// Uses `libm`, which gives the same bits on every machine.

/// Returns the inclination and the azimuth of a vector, rad.
pub(in crate::configuration) fn angles(&[x, y, z]: &[f64; 3]) -> [f64; 2] {
    [libm::atan2(libm::sqrt(x * x + y * y), z), libm::atan2(y, x)]
}

/// Returns the unit vector of an inclination and an azimuth, rad.
pub(in crate::configuration) fn unit_vector(inclination: f64, azimuth: f64) -> [f64; 3] {
    let ((s, c), (sin, cos)) = (libm::sincos(inclination), libm::sincos(azimuth));
    [s * cos, s * sin, c]
}
