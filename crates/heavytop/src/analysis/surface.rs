//! The surfaces of Poincaré sections of tops: [`Surface`], [`SurfaceVariable`].

use crate::tops::coordinate::Coordinate;
use collective_integrators::Direction;
use core::f64::consts::{PI, TAU};
use core::fmt;
use lie_poisson::{Covector, Pair, Se3Dual};
use nalgebra::{Vector2, Vector3};

/// A function on se(3)∗ to which a surface gives a value: a coordinate, or the angle of Γ about an axis.
///
/// The angle about e_i is
///
/// ```text
/// φ_i = atan2(Γ_k, Γ_j),    (i, j, k) cyclic,
/// ```
///
/// in radians. It grows where Γ turns about e_i in the positive sense, and is determined up to multiples of 2π.
///
/// # Example
/// ```
/// use heavytop::{Coordinate, SurfaceVariable};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let mu = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(-0.6, 0.0, 0.8));
/// assert_eq!(SurfaceVariable::Coordinate(Coordinate::Pi3).of(&mu), 4.0);
/// assert_eq!(SurfaceVariable::Angle3.of(&mu), std::f64::consts::PI);
/// assert_eq!(SurfaceVariable::named("atan2(Gamma2, Gamma1)"), Some(SurfaceVariable::Angle3));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SurfaceVariable {
    /// A coordinate, in its unit.
    Coordinate(Coordinate),
    /// The angle atan2(Γ₃, Γ₂) of Γ about e₁, rad.
    Angle1,
    /// The angle atan2(Γ₁, Γ₃) of Γ about e₂, rad.
    Angle2,
    /// The angle atan2(Γ₂, Γ₁) of Γ about e₃, rad.
    Angle3,
}

impl From<Coordinate> for SurfaceVariable {
    fn from(coordinate: Coordinate) -> Self {
        Self::Coordinate(coordinate)
    }
}

impl SurfaceVariable {
    /// All variables: the six coordinates in the order of the columns of tables, and the three angles.
    pub const ALL: [Self; 9] = [
        Self::Coordinate(Coordinate::Pi1),
        Self::Coordinate(Coordinate::Pi2),
        Self::Coordinate(Coordinate::Pi3),
        Self::Coordinate(Coordinate::Gamma1),
        Self::Coordinate(Coordinate::Gamma2),
        Self::Coordinate(Coordinate::Gamma3),
        Self::Angle1,
        Self::Angle2,
        Self::Angle3,
    ];

    /// Returns the value at (Π, Γ); that of an angle is between −π and π.
    #[must_use]
    pub fn of(self, mu: &Se3Dual) -> f64 {
        match self {
            Self::Coordinate(coordinate) => coordinate.of(mu),
            _ => angle_about(self.axis(), &mu.0.1),
        }
    }

    /// Returns the axis of the variable: 0, 1 or 2.
    #[must_use]
    pub const fn axis(self) -> usize {
        match self {
            Self::Coordinate(coordinate) => coordinate.axis(),
            Self::Angle1 => 0,
            Self::Angle2 => 1,
            Self::Angle3 => 2,
        }
    }

    /// Returns the period 2π of an angle, and `None` for a coordinate.
    #[must_use]
    pub const fn period(self) -> Option<f64> {
        match self {
            Self::Coordinate(_) => None,
            _ => Some(TAU),
        }
    }

    /// Returns the name in configurations, which is a formula in the coordinates: `Pi1` … `Gamma3`,
    /// `atan2(Gamma2, Gamma1)` …
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Coordinate(coordinate) => coordinate.name(),
            Self::Angle1 => "atan2(Gamma3, Gamma2)",
            Self::Angle2 => "atan2(Gamma1, Gamma3)",
            Self::Angle3 => "atan2(Gamma2, Gamma1)",
        }
    }

    /// Returns the variable with a name, with or without spaces.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let letters = |text: &str| text.split_whitespace().collect::<String>();
        Self::ALL.into_iter().find(|variable| letters(variable.name()) == letters(name))
    }
}

impl fmt::Display for SurfaceVariable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A surface in se(3)∗ on which a variable has a given level.
///
/// If the variable is an angle, the level is one up to multiples of 2π, so that the surface is passed once per turn of Γ;
/// the jump of `atan2` from π to −π is not on it, unless the level is π.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Surface {
    /// The variable that is fixed.
    pub variable: SurfaceVariable,
    /// The value of the variable on the surface, in its unit.
    pub level: f64,
    /// The directions of the crossings that count.
    pub direction: Direction,
}

/// A point of the plane of a section: what it says of the states over it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// The unit vector Γ.
    pub(crate) gamma: Vector3<f64>,
    /// A direction, a unit vector.
    pub(crate) axis: Vector3<f64>,
    /// The component of Π along it, kg m²/s.
    pub(crate) momentum: f64,
}

impl Surface {
    /// Returns the variable at a state minus its level; for an angle the difference of least size.
    pub(crate) fn value(&self, mu: &Se3Dual) -> f64 {
        let difference = self.variable.of(mu) - self.level;
        match self.variable.period() {
            Some(period) => difference - period * (difference / period).round(),
            None => difference,
        }
    }

    /// Returns a number with the sign of the rate of the variable, at a state with this rate of change.
    pub(crate) fn rate(&self, mu: &Se3Dual, rate: &Se3Dual) -> f64 {
        match self.variable {
            SurfaceVariable::Coordinate(coordinate) => coordinate.of(rate),
            _ => {
                let (j, k) = others(self.variable.axis());
                let (gamma, rate) = (&mu.0.1, &rate.0.1);
                rate[k] * gamma[j] - rate[j] * gamma[k]
            }
        }
    }

    /// Returns the point (x, y) of the plane for a state.
    pub(crate) fn plane(&self, mu: &Se3Dual) -> Vector2<f64> {
        let Covector(Pair(pi, gamma)) = mu;
        let axis = self.variable.axis();
        match self.variable {
            SurfaceVariable::Coordinate(coordinate) => {
                let other = if coordinate.is_momentum() { gamma } else { pi };
                Vector2::new(angle_about(axis, gamma).rem_euclid(TAU), other[axis])
            }
            _ => {
                let (j, k) = others(axis);
                let inclination = gamma[j].hypot(gamma[k]).atan2(gamma[axis]);
                Vector2::new(inclination, pi.dot(&self.axis()))
            }
        }
    }

    /// Returns the largest x of the plane; the least is 0.
    pub(crate) fn width(&self) -> f64 {
        if self.variable.period().is_some() { PI } else { TAU }
    }

    /// Returns what a point of the plane says of the states over it.
    pub(crate) fn place(&self, plane: &Vector2<f64>) -> Place {
        let (axis, level) = (self.variable.axis(), self.level);
        let (gamma, momentum) = match self.variable {
            SurfaceVariable::Coordinate(coordinate) if coordinate.is_momentum() => {
                (vertical(axis, plane.x, plane.y), level)
            }
            SurfaceVariable::Coordinate(_) => (vertical(axis, plane.x, level), plane.y),
            _ => {
                let (sin, cos) = plane.x.sin_cos();
                (around(axis, cos, sin, level), plane.y)
            }
        };
        Place { gamma, axis: self.axis(), momentum }
    }

    /// Returns the direction along which a point of the plane, or the surface, has the component of Π: e_i, or for an angle
    /// about e_i the axis e_i × Γ/|e_i × Γ| of the inclination, the same for all states on the surface.
    pub(crate) fn axis(&self) -> Vector3<f64> {
        let axis = self.variable.axis();
        match self.variable {
            SurfaceVariable::Coordinate(_) => Vector3::ith(axis, 1.0),
            _ => {
                let (sin, cos) = self.level.sin_cos();
                components(axis, [0.0, -sin, cos])
            }
        }
    }
}

/// Returns the two axes j and k after the axis i, (i, j, k) cyclic.
const fn others(axis: usize) -> (usize, usize) {
    ((axis + 1) % 3, (axis + 2) % 3)
}

/// Returns the angle of a vector about e_i, between −π and π.
fn angle_about(axis: usize, v: &Vector3<f64>) -> f64 {
    let (j, k) = others(axis);
    v[k].atan2(v[j])
}

/// Returns the unit vector Γ with Γ_i = height at an angle about e_i, counted from e_j.
pub(crate) fn vertical(axis: usize, angle: f64, height: f64) -> Vector3<f64> {
    around(axis, height, (1.0 - height * height).max(0.0).sqrt(), angle)
}

/// Returns the vector with the component `height` along e_i and of a length across it, at an angle about e_i.
fn around(axis: usize, height: f64, radius: f64, angle: f64) -> Vector3<f64> {
    components(axis, [height, radius * angle.cos(), radius * angle.sin()])
}

/// Returns the vector with these components along e_i, e_j and e_k.
fn components(axis: usize, [height, x, y]: [f64; 3]) -> Vector3<f64> {
    let (j, k) = others(axis);
    let mut v = Vector3::zeros();
    v[axis] = height;
    v[j] = x;
    v[k] = y;
    v
}
