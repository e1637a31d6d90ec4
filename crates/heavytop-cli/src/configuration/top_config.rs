//! The tables `[body]` and `[initial]`: a top and the state from which it starts.

use crate::Error;
use heavytop::{Body, HeavyTop, require_unit};
use lie_poisson::Se3Dual;
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
}

/// The table `[initial]`: the state at t = 0, in the body frame.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct InitialConfig {
    /// The angular momentum Π(0), kg m²/s.
    pub angular_momentum: [f64; 3],
    /// The vertical direction Γ(0), a unit vector.
    pub vertical: [f64; 3],
}

impl Default for BodyConfig {
    fn default() -> Self {
        Self {
            inertia: [2.0, 2.0, 1.0],
            mass: 1.0,
            gravity: 1.0,
            length: 1.0,
            center_of_mass: [1.0, 0.0, 0.0],
        }
    }
}

impl Default for InitialConfig {
    fn default() -> Self {
        Self { angular_momentum: [2.0, 3.0, 4.0], vertical: [0.5, 0.0, 0.75_f64.sqrt()] }
    }
}

impl BodyConfig {
    /// Returns the top with these parameters.
    ///
    /// # Errors
    /// If there is no such top.
    pub fn top(&self) -> Result<HeavyTop, Error> {
        let Self { inertia, mass, gravity, length, center_of_mass } = *self;
        let (inertia, center_of_mass) = (inertia.into(), center_of_mass.into());
        HeavyTop::new(&Body { inertia, mass, gravity, length, center_of_mass }).map_err(Error::Body)
    }
}

impl InitialConfig {
    /// Returns the state (Π(0), Γ(0)).
    ///
    /// # Errors
    /// If Π is not finite or Γ is no unit vector.
    pub fn start(&self) -> Result<Se3Dual, Error> {
        let Self { angular_momentum, vertical } = *self;
        let vertical = Vector3::from(vertical);
        require_unit("vertical", &vertical).map_err(Error::Vertical)?;
        if let Some(&value) = angular_momentum.iter().find(|x| !x.is_finite()) {
            return Err(Error::OutOfRange { name: "angular_momentum", range: "finite", value });
        }
        Ok(Se3Dual::new(angular_momentum.into(), vertical))
    }
}
