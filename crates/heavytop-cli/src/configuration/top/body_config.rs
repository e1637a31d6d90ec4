//! The table `[body]`: the parameters of the top.

use super::directions::scaled;
use super::inertia::{About, Inertia};
use crate::errors::Error;
use heavytop::{Body, HeavyTop, PrincipalAxes, TopError, point_inertia, require_possible_body};
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

/// The table `[body]`: the parameters of the top.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "BodyKeys", into = "BodyKeys")]
pub struct BodyConfig {
    /// The moments of inertia about the support, kg m², unless `inertia_about` says otherwise.
    pub inertia: Inertia,
    /// The point about which the moments are taken.
    pub inertia_about: About,
    /// The mass of the top, kg; it plays no part where there is a weight moment.
    pub mass: f64,
    /// The gravitational acceleration, m/s²; 0 gives the free rigid body. It plays no part where there is a weight moment.
    pub gravity: f64,
    /// The distance from the support to the centre of mass, m; it plays no part where there is a weight moment.
    pub length: f64,
    /// The weight moment m g l, N m, where no more is known of mass, gravity and length.
    pub weight_moment: Option<f64>,
    /// The direction from the support to the centre of mass in the body frame, a unit vector.
    pub center_of_mass: [f64; 3],
    /// Whether `center_of_mass` is scaled to length 1, instead of being refused if it has another length.
    pub normalise: bool,
}

/// The keys of `[body]`.
#[derive(Default, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
struct BodyKeys {
    inertia: Option<Inertia>,
    #[serde(skip_serializing_if = "is_support")]
    inertia_about: About,
    mass: Option<f64>,
    gravity: Option<f64>,
    length: Option<f64>,
    weight_moment: Option<f64>,
    center_of_mass: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "is_false")]
    normalise: bool,
}

fn is_support(about: &About) -> bool {
    *about == About::Support
}

fn is_false(value: &bool) -> bool {
    !value
}

/// The paper's top, of which m g l alone is known.
impl Default for BodyConfig {
    fn default() -> Self {
        Self {
            inertia: Inertia::Principal([2.0, 2.0, 1.0]),
            inertia_about: About::Support,
            mass: 1.0,
            gravity: 1.0,
            length: 1.0,
            weight_moment: Some(1.0),
            center_of_mass: [1.0, 0.0, 0.0],
            normalise: false,
        }
    }
}

/// The message begins with the key that is at fault, and ends with what to write.
impl TryFrom<BodyKeys> for BodyConfig {
    type Error = &'static str;

    fn try_from(keys: BodyKeys) -> Result<Self, &'static str> {
        let own = Self::default();
        let has_factor = [keys.mass, keys.gravity, keys.length].iter().any(Option::is_some);
        if keys.weight_moment.is_some() && has_factor {
            return Err(
                "`weight_moment` excludes `mass`, `gravity` and `length`, whose product it is; write it or them",
            );
        }
        Ok(Self {
            inertia: keys.inertia.unwrap_or(own.inertia),
            inertia_about: keys.inertia_about,
            mass: keys.mass.unwrap_or(own.mass),
            gravity: keys.gravity.unwrap_or(own.gravity),
            length: keys.length.unwrap_or(own.length),
            weight_moment: keys.weight_moment.or(own.weight_moment.filter(|_| !has_factor)),
            center_of_mass: keys.center_of_mass.unwrap_or(own.center_of_mass),
            normalise: keys.normalise,
        })
    }
}

impl From<BodyConfig> for BodyKeys {
    fn from(body: BodyConfig) -> Self {
        let factor = |value: f64| body.weight_moment.is_none().then_some(value);
        Self {
            inertia: Some(body.inertia),
            inertia_about: body.inertia_about,
            mass: factor(body.mass),
            gravity: factor(body.gravity),
            length: factor(body.length),
            weight_moment: body.weight_moment,
            center_of_mass: Some(body.center_of_mass),
            normalise: body.normalise,
        }
    }
}

impl BodyConfig {
    /// Returns the direction of the centre of mass, which is no unit vector if the configuration has none.
    #[must_use]
    pub fn center(&self) -> [f64; 3] {
        scaled(self.center_of_mass, self.normalise)
    }

    /// Returns the position of the centre of mass, m.
    fn position(&self) -> Vector3<f64> {
        Vector3::from(self.center()) * self.length
    }

    /// Returns the inertia matrix about the support, kg m².
    fn matrix(&self) -> Matrix3<f64> {
        match self.inertia_about {
            About::Support => self.inertia.matrix(),
            About::CenterOfMass => {
                self.inertia.matrix() + point_inertia(self.mass, &self.position())
            }
        }
    }

    /// Returns the principal moments about the support, and the principal axes in the axes of the table.
    ///
    /// # Errors
    /// If the moments are about the centre of mass and mass and length are not known, if they are no moments of a body
    /// then, or if a matrix is not symmetric.
    pub fn axes(&self) -> Result<PrincipalAxes, Error> {
        if self.inertia_about == About::CenterOfMass {
            if self.weight_moment.is_some() {
                return Err(Error::CentralMoments);
            }
            require_possible_body(&self.matrix(), self.mass, &self.position())
                .map_err(Error::Body)?;
        } else if let Inertia::Principal(moments) = self.inertia {
            return Ok(PrincipalAxes::aligned(moments.into()));
        }
        PrincipalAxes::of(&self.matrix()).map_err(Error::Body)
    }

    /// Returns the top with these parameters, in its principal axes.
    ///
    /// # Errors
    /// If there is no such top.
    pub fn top(&self) -> Result<HeavyTop, Error> {
        let Self { mut mass, mut gravity, mut length, .. } = *self;
        if let Some(value) = self.weight_moment {
            let name = "weight_moment";
            match value {
                value if !value.is_finite() => {
                    return Err(Error::Body(TopError::NotFinite { name, value }));
                }
                value if value < 0.0 => {
                    return Err(Error::Body(TopError::Negative { name, value }));
                }
                value => (mass, gravity, length) = (1.0, value, 1.0),
            }
        }
        let axes = self.axes()?;
        let (inertia, center) = (axes.moments(), Vector3::from(self.center()));
        let center_of_mass = axes.to_principal(&center);
        HeavyTop::new(&Body { inertia, mass, gravity, length, center_of_mass }).map_err(Error::Body)
    }

    /// Returns whether the table gives the principal moments about the support, along its own axes.
    pub(in crate::configuration) fn names(&self, axes: &PrincipalAxes) -> bool {
        self.inertia == Inertia::Principal(axes.moments().into()) && axes.is_aligned()
    }

    /// Returns the angular momentum of an angular velocity (rad/s), in the axes of the table, kg m²/s.
    #[must_use]
    pub fn angular_momentum(&self, velocity: [f64; 3]) -> [f64; 3] {
        match (self.inertia, self.inertia_about) {
            (Inertia::Principal(moments), About::Support) => {
                std::array::from_fn(|i| moments[i] * velocity[i])
            }
            _ => (self.matrix() * Vector3::from(velocity)).into(),
        }
    }

    /// Returns the reason why no body has these moments with this mass at this distance from the support. There is none
    /// where the top has no weight, or no more than m g l is known.
    #[must_use]
    pub fn impossibility(&self) -> Option<TopError> {
        if self.weight_moment.is_some() || self.gravity == 0.0 {
            return None;
        }
        let possible = require_possible_body(&self.matrix(), self.mass, &self.position());
        possible.err().filter(|error| matches!(error, TopError::ImpossibleBody { .. }))
    }
}
