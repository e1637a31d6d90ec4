//! What physicists read off the state of a top: [`TopQuantity`].

use super::top_in_axes::TopInAxes;
use heavytop::EulerAngles;
use lie_poisson::{Covector, Pair, Quaternion, Se3Dual};

/// A quantity of a top in motion besides its state and what it conserves. Directions are in the axes of the users.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TopQuantity {
    /// The angular velocity Ω = I⁻¹Π in the body frame, rad/s.
    AngularVelocity,
    /// The Euler angles φ, θ, ψ of the attitude, rad, by [`EulerAngles`].
    EulerAngles,
    /// The height l c·Γ of the centre of mass above the support, m.
    Height,
    /// The kinetic energy ½ Π·I⁻¹Π, J.
    KineticEnergy,
    /// The potential energy m g l c·Γ, J.
    PotentialEnergy,
    /// The angular momentum R Π in the spatial frame, kg m²/s, of which the third component is conserved.
    SpatialMomentum,
}

impl TopQuantity {
    /// All quantities, with their names.
    pub const NAMES: &'static [(&'static str, Self)] = &[
        ("Omega", Self::AngularVelocity),
        ("euler-angles", Self::EulerAngles),
        ("height", Self::Height),
        ("kinetic", Self::KineticEnergy),
        ("potential", Self::PotentialEnergy),
        ("spatial-momentum", Self::SpatialMomentum),
    ];

    /// Returns the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, other)| *other == self).map_or("", |(name, _)| name)
    }

    /// Returns the quantity that has a column of this name, such as the Euler angles for `theta`.
    #[must_use]
    pub fn with_column(column: &str) -> Option<Self> {
        let has = |(_, quantity): &&(&str, Self)| quantity.columns().contains(&column);
        Self::NAMES.iter().find(has).map(|(_, quantity)| *quantity)
    }

    /// Returns the names of the columns of a table of the quantity.
    #[must_use]
    pub const fn columns(self) -> &'static [&'static str] {
        match self {
            Self::AngularVelocity => &["Omega1", "Omega2", "Omega3"],
            Self::EulerAngles => &["phi", "theta", "psi"],
            Self::Height => &["height"],
            Self::KineticEnergy => &["kinetic"],
            Self::PotentialEnergy => &["potential"],
            Self::SpatialMomentum => {
                &["spatial_momentum1", "spatial_momentum2", "spatial_momentum3"]
            }
        }
    }

    /// Returns the unit.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::AngularVelocity => "rad/s",
            Self::EulerAngles => "rad",
            Self::Height => "m",
            Self::KineticEnergy | Self::PotentialEnergy => "J",
            Self::SpatialMomentum => "kg m²/s",
        }
    }

    /// Returns whether the quantity is one of the attitude, which (Π, Γ) does not determine.
    #[must_use]
    pub const fn needs_attitude(self) -> bool {
        matches!(self, Self::EulerAngles | Self::SpatialMomentum)
    }

    /// Appends the values at a state (Π, Γ) and an attitude in the axes of the users. `length` is the distance l from the
    /// support to the centre of mass, m. What needs an attitude is NaN without one.
    ///
    /// # Example
    /// The height and the potential energy of a top of 2 kg whose centre of mass is at 5 cm on its axis.
    /// ```
    /// use heavytop::{Body, HeavyTop};
    /// use lie_poisson::Se3Dual;
    /// use lie_poisson_runs::{TopInAxes, TopQuantity};
    /// use nalgebra::Vector3;
    /// let (inertia, center_of_mass) = (Vector3::new(0.008, 0.008, 0.001), Vector3::z());
    /// let body = Body { inertia, mass: 2.0, gravity: 9.81, length: 0.05, center_of_mass };
    /// let top = TopInAxes::from(HeavyTop::new(&body)?);
    /// let mu = Se3Dual::new(Vector3::zeros(), Vector3::new(0.0, 0.6, 0.8));
    /// let mut values = Vec::new();
    /// for quantity in [TopQuantity::Height, TopQuantity::PotentialEnergy] {
    ///     quantity.append(&top, (&mu, None), 0.05, &mut values);
    /// }
    /// assert!((values[0] - 0.04).abs() < 1e-17 && (values[1] - 2.0 * 9.81 * 0.04).abs() < 1e-15);
    /// # Ok::<(), heavytop::TopError>(())
    /// ```
    pub fn append(
        self,
        model: &TopInAxes,
        (given, attitude): (&Se3Dual, Option<&Quaternion>),
        length: f64,
        values: &mut Vec<f64>,
    ) {
        let (top, axes) = (&model.top, &model.axes);
        let Covector(Pair(pi, gamma)) =
            if axes.is_aligned() { *given } else { axes.state_to_principal(given) };
        let missing = Quaternion { scalar: f64::NAN, vector: [f64::NAN; 3].into() };
        let attitude = attitude.unwrap_or(&missing);
        match self {
            Self::AngularVelocity => {
                values.extend(axes.from_principal(&top.angular_velocity(&pi)).iter());
            }
            Self::EulerAngles => {
                let EulerAngles { precession, nutation, spin } = EulerAngles::of(attitude);
                values.extend([precession, nutation, spin]);
            }
            Self::Height => values.push(length * gamma.dot(&top.center_of_mass())),
            Self::KineticEnergy => values.push(top.kinetic_energy(&pi)),
            Self::PotentialEnergy => values.push(top.potential_energy(&gamma)),
            Self::SpatialMomentum => values.extend(attitude.rotate(&given.0.0).iter()),
        }
    }
}
