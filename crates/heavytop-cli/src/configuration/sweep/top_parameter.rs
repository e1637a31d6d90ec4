//! The numbers of a top that a sweep may vary.

use crate::configuration::top::{
    AZIMUTH, AngleRange, BodyConfig, INCLINATION, Inertia, InitialConfig, angles, normalised,
    unit_vector,
};
use crate::vocabulary::named::{by_name, name_of};

/// A number of `[body]` or `[initial]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TopParameter {
    /// A principal moment of inertia, `body.inertia[i]`.
    Inertia(usize),
    /// The mass of the top, `body.mass`.
    Mass,
    /// The gravitational acceleration, `body.gravity`.
    Gravity,
    /// The distance from the support to the centre of mass, `body.length`.
    Length,
    /// The weight moment m g l, `body.weight_moment`.
    WeightMoment,
    /// A number of the direction to the centre of mass, `body.center_of_mass…`.
    CenterOfMass(Part),
    /// A component of the initial angular momentum Π(0), `initial.angular_momentum[i]`.
    AngularMomentum(usize),
    /// A component of the initial angular velocity Ω(0), `initial.angular_velocity[i]`.
    AngularVelocity(usize),
    /// A number of the direction Γ(0), `initial.vertical…`.
    Vertical(Part),
}

/// A number that describes a unit vector v = (sin ϑ cos φ, sin ϑ sin φ, cos ϑ).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The component v_i, `[i]`; the other components stay.
    Component(usize),
    /// The inclination ϑ, `.inclination`, rad; φ stays.
    Inclination,
    /// The azimuth φ, `.azimuth`, rad; ϑ stays.
    Azimuth,
}

use Part::{Azimuth, Component, Inclination};

impl TopParameter {
    const NAMES: &[(&'static str, Self)] = &[
        ("body.inertia[0]", Self::Inertia(0)),
        ("body.inertia[1]", Self::Inertia(1)),
        ("body.inertia[2]", Self::Inertia(2)),
        ("body.mass", Self::Mass),
        ("body.gravity", Self::Gravity),
        ("body.length", Self::Length),
        ("body.weight_moment", Self::WeightMoment),
        ("body.center_of_mass[0]", Self::CenterOfMass(Component(0))),
        ("body.center_of_mass[1]", Self::CenterOfMass(Component(1))),
        ("body.center_of_mass[2]", Self::CenterOfMass(Component(2))),
        ("body.center_of_mass.inclination", Self::CenterOfMass(Inclination)),
        ("body.center_of_mass.azimuth", Self::CenterOfMass(Azimuth)),
        ("initial.angular_momentum[0]", Self::AngularMomentum(0)),
        ("initial.angular_momentum[1]", Self::AngularMomentum(1)),
        ("initial.angular_momentum[2]", Self::AngularMomentum(2)),
        ("initial.angular_velocity[0]", Self::AngularVelocity(0)),
        ("initial.angular_velocity[1]", Self::AngularVelocity(1)),
        ("initial.angular_velocity[2]", Self::AngularVelocity(2)),
        ("initial.vertical[0]", Self::Vertical(Component(0))),
        ("initial.vertical[1]", Self::Vertical(Component(1))),
        ("initial.vertical[2]", Self::Vertical(Component(2))),
        ("initial.vertical.inclination", Self::Vertical(Inclination)),
        ("initial.vertical.azimuth", Self::Vertical(Azimuth)),
    ];

    /// Returns the parameter with this path in the configuration.
    ///
    /// # Errors
    /// Returns a message with the paths that there are.
    pub(super) fn by_name(name: &str) -> Result<Self, String> {
        // The keys of `[initial]` for the angles of the vertical.
        let name = match name {
            "initial.inclination" => "initial.vertical.inclination",
            "initial.azimuth" => "initial.vertical.azimuth",
            name => name,
        };
        by_name("parameter", Self::NAMES, name)
    }

    /// Returns the path in the configuration.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_of(Self::NAMES, self)
    }

    /// Returns the symbol and the unit.
    #[must_use]
    pub fn label(self) -> String {
        let indexed = |symbol: &str, i: usize| format!("{symbol}{}", ["₁", "₂", "₃"][i % 3]);
        let of_vector = |symbol: &str, part| match part {
            Component(i) => indexed(symbol, i),
            Inclination => format!("inclination of {symbol} (rad)"),
            Azimuth => format!("azimuth of {symbol} (rad)"),
        };
        match self {
            Self::Inertia(i) => indexed("I", i) + " (kg m²)",
            Self::Mass => "mass (kg)".into(),
            Self::Gravity => "gravity (m/s²)".into(),
            Self::Length => "length (m)".into(),
            Self::WeightMoment => "m g l (N m)".into(),
            Self::CenterOfMass(part) => of_vector("c", part),
            Self::AngularMomentum(i) => indexed("Π", i) + "(0) (kg m²/s)",
            Self::AngularVelocity(i) => indexed("Ω", i) + "(0) (rad/s)",
            Self::Vertical(part) => of_vector("Γ(0)", part),
        }
    }

    /// Returns whether the parameter is a number of `[body]`.
    #[must_use]
    pub fn is_of_body(self) -> bool {
        !matches!(self, Self::AngularMomentum(_) | Self::AngularVelocity(_) | Self::Vertical(_))
    }

    /// Returns whether the parameter is a factor of the weight moment.
    #[must_use]
    pub fn is_factor(self) -> bool {
        matches!(self, Self::Mass | Self::Gravity | Self::Length)
    }

    /// Returns the range of the parameter if it is an angle.
    pub(super) fn angle(self) -> Option<&'static AngleRange> {
        match self {
            Self::CenterOfMass(Inclination) | Self::Vertical(Inclination) => Some(&INCLINATION),
            Self::CenterOfMass(Azimuth) | Self::Vertical(Azimuth) => Some(&AZIMUTH),
            _ => None,
        }
    }

    /// Returns whether the parameter is a component of the angular momentum.
    #[must_use]
    pub fn is_angular_momentum(self) -> bool {
        matches!(self, Self::AngularMomentum(_))
    }

    /// Returns whether the parameter is a component of the angular velocity.
    #[must_use]
    pub fn is_angular_velocity(self) -> bool {
        matches!(self, Self::AngularVelocity(_))
    }

    /// Returns whether the parameter is a component of a unit vector.
    #[must_use]
    pub fn is_component(self) -> bool {
        matches!(self, Self::CenterOfMass(Component(_)) | Self::Vertical(Component(_)))
    }

    /// Returns whether the parameter is an azimuth, which has to be set after the inclination: an upright vector has
    /// no azimuth to keep.
    #[must_use]
    pub fn is_azimuth(self) -> bool {
        matches!(self, Self::CenterOfMass(Azimuth) | Self::Vertical(Azimuth))
    }

    /// Returns whether two parameters contradict each other: they are one, one is an angle of a vector and the other a
    /// component of it, or one is m g l and the other a factor of it.
    #[must_use]
    pub fn clashes(self, other: Self) -> bool {
        let components = |one, other| matches!((one, other), (Component(_), Inclination | Azimuth));
        let either = |a, b| components(a, b) || components(b, a);
        let product = |one: Self, other: Self| one == Self::WeightMoment && other.is_factor();
        self == other
            || product(self, other)
            || product(other, self)
            || match (self, other) {
                (Self::CenterOfMass(a), Self::CenterOfMass(b))
                | (Self::Vertical(a), Self::Vertical(b)) => either(a, b),
                _ => false,
            }
    }

    /// Sets the parameter to a value.
    pub fn set(self, value: f64, body: &mut BodyConfig, initial: &mut InitialConfig) {
        let put = |vector: &mut [f64; 3], i: usize| {
            vector.iter_mut().skip(i).take(1).for_each(|component| *component = value);
        };
        let part_of = |vector: &mut [f64; 3], part| match part {
            Component(i) => put(vector, i),
            Inclination => *vector = unit_vector(value, angles(vector)[1]),
            Azimuth => *vector = unit_vector(angles(vector)[0], value),
        };
        match self {
            Self::Inertia(i) => match &mut body.inertia {
                Inertia::Principal(moments) => put(moments, i),
                Inertia::Matrix(_) => {}
            },
            Self::Mass => (body.mass, body.weight_moment) = (value, None),
            Self::Gravity => (body.gravity, body.weight_moment) = (value, None),
            Self::Length => (body.length, body.weight_moment) = (value, None),
            Self::WeightMoment => body.weight_moment = Some(value),
            Self::CenterOfMass(part) => part_of(&mut body.center_of_mass, part),
            Self::AngularMomentum(i) => put(&mut initial.angular_momentum, i),
            Self::AngularVelocity(i) => put(initial.angular_velocity.get_or_insert_default(), i),
            Self::Vertical(Inclination) if initial.inclination.is_some() => {
                initial.inclination = Some(value);
            }
            Self::Vertical(Azimuth) if initial.inclination.is_some() => {
                initial.azimuth = Some(value);
            }
            Self::Vertical(part) => {
                // The number is one of the vector, even if the configuration has angles.
                initial.vertical = initial.direction();
                (initial.inclination, initial.azimuth) = (None, None);
                (initial.attitude, initial.euler_angles) = (None, None);
                part_of(&mut initial.vertical, part);
            }
        }
    }

    /// Returns the component of a unit vector with which a top is run, after any scaling to length 1, or `None` for another
    /// number, which is run as it is set.
    #[must_use]
    pub fn component_run(self, body: &BodyConfig, initial: &InitialConfig) -> Option<f64> {
        match self {
            Self::CenterOfMass(Component(i)) => body.center().get(i).copied(),
            Self::Vertical(Component(i)) => initial.direction().get(i).copied(),
            _ => None,
        }
    }

    /// Scales the unit vector of the parameter to length 1; a vector without a direction stays.
    pub fn normalise(self, body: &mut BodyConfig, initial: &mut InitialConfig) {
        let vector = match self {
            Self::CenterOfMass(_) => &mut body.center_of_mass,
            Self::Vertical(_) => &mut initial.vertical,
            _ => return,
        };
        *vector = normalised(*vector);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn every_path_sets_its_number_and_no_other() {
        for &(name, parameter) in TopParameter::NAMES {
            assert_eq!(TopParameter::by_name(name).unwrap(), parameter);
            let (mut body, mut initial) = (BodyConfig::default(), InitialConfig::default());
            parameter.set(0.3, &mut body, &mut initial);
            assert_eq!(body != BodyConfig::default(), parameter.is_of_body(), "{name}");
            assert_eq!(initial != InitialConfig::default(), !parameter.is_of_body(), "{name}");
            let [inclination, azimuth] = angles(&initial.vertical);
            match parameter {
                TopParameter::Vertical(Inclination) => assert!((inclination - 0.3).abs() < 1e-15),
                TopParameter::Vertical(Azimuth) => assert!((azimuth - 0.3).abs() < 1e-15),
                TopParameter::Vertical(Component(i)) => assert_eq!(initial.vertical[i], 0.3),
                _ => {}
            }
        }
        assert!(TopParameter::by_name("body.inertia[3]").is_err());
    }

    #[test]
    fn vectors_are_scaled_only_when_asked() {
        let (mut body, mut initial) = (BodyConfig::default(), InitialConfig::default());
        let parameter = TopParameter::CenterOfMass(Component(1));
        parameter.set(0.75, &mut body, &mut initial);
        assert_eq!(body.center_of_mass, [1.0, 0.75, 0.0]);
        parameter.normalise(&mut body, &mut initial);
        assert_eq!(body.center_of_mass, [0.8, 0.6, 0.0]);
        for scale in [1e-300, 1e200] {
            body.center_of_mass = [3.0 * scale, 0.0, 4.0 * scale];
            parameter.normalise(&mut body, &mut initial);
            let expected = [0.6, 0.0, 0.8];
            assert!((0..3).all(|i| (body.center_of_mass[i] - expected[i]).abs() < 1e-15));
        }
        for none in [[0.0; 3], [f64::INFINITY, 0.0, 0.0]] {
            body.center_of_mass = none;
            parameter.normalise(&mut body, &mut initial);
            assert_eq!(body.center_of_mass, none);
        }
    }
}
