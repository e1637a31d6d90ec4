//! The heavy gyrostat as a Hamiltonian on se(3)∗.

use super::principal_moments::PrincipalMoments;
use crate::error::{SystemError, require_finite, require_not_negative};
use lie_poisson::hessian_by_dual_numbers;
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Pair, Real, Se3, Se3Dual};
use nalgebra::Vector3;

/// The heavy gyrostat: a heavy body with a fixed point, and with a rotor inside whose angular momentum ℓ relative to
/// the body is constant.
///
/// It is a Hamiltonian on se(3)∗ with the minus bracket, in the body frame:
///
/// ```text
/// h(Π, Γ) = ½ (Π − ℓ)·I⁻¹(Π − ℓ) + w Γ·r,    dh = (Ω, γ) = (I⁻¹(Π − ℓ), w r)
/// dΠ/dt = Π × Ω + w Γ × r,    dΓ/dt = Γ × Ω
/// ```
///
/// Π is the total angular momentum (kg m²/s), Γ the upward vertical seen from the body, w the weight (N) and r
/// the centre of mass (m). The Casimirs are |Γ|² and Π·Γ. Without a rotor, ℓ = 0, it is the heavy top.
///
/// Source: N. E. Zhukovskii, *On the motion of a rigid body with cavities filled with a
/// homogeneous liquid* (1885); E. Leimanis, *The General Problem of the Motion of Coupled Rigid
/// Bodies about a Fixed Point* (1965), §7.
///
/// # Example
/// ```
/// use lie_poisson::{Hamiltonian, Pair, Se3Dual};
/// use lie_poisson_systems::Gyrostat;
/// use nalgebra::Vector3;
/// let rotor = Vector3::new(0.0, 0.0, 5.0);
/// let gyrostat = Gyrostat::new(Vector3::new(2.0, 2.0, 1.0), 1.0, Vector3::z(), rotor)?;
/// // at Π = ℓ the body is at rest, and only the weight acts
/// let Pair(omega, gamma) = gyrostat.differential(&Se3Dual::new(rotor, Vector3::x()));
/// assert_eq!((omega, gamma), (Vector3::zeros(), Vector3::z()));
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gyrostat {
    moments: PrincipalMoments,
    weight: f64,
    center_of_mass: Vector3<f64>,
    rotor: Vector3<f64>,
}

impl Gyrostat {
    /// Creates a gyrostat from the principal moments I₁, I₂, I₃ of body and rotor together with respect to the
    /// fixed point (kg m²), the weight w = m g (N), the centre of mass r seen from the fixed point (m), and the
    /// angular momentum ℓ of the rotor relative to the body (kg m²/s).
    ///
    /// The vectors r and ℓ are in the body frame, along the principal axes.
    ///
    /// # Errors
    /// Returns [`SystemError`] unless the moments are positive and obey the triangle inequality, the weight
    /// is not negative, and every number is finite, including w r and the inverses of the moments.
    pub fn new(
        inertia: Vector3<f64>,
        weight: f64,
        center_of_mass: Vector3<f64>,
        rotor: Vector3<f64>,
    ) -> Result<Self, SystemError> {
        let moments = PrincipalMoments::new(&inertia)?;
        require_not_negative("weight", weight)?;
        require_finite_vector(
            ["center_of_mass[0]", "center_of_mass[1]", "center_of_mass[2]"],
            &center_of_mass,
        )?;
        let torque =
            ["weight·center_of_mass[0]", "weight·center_of_mass[1]", "weight·center_of_mass[2]"];
        require_finite_vector(torque, &(center_of_mass * weight))?;
        require_finite_vector(["rotor[0]", "rotor[1]", "rotor[2]"], &rotor)?;
        Ok(Self { moments, weight, center_of_mass, rotor })
    }

    /// Returns Π − ℓ, the part of Π that moves with the body.
    #[cfg_attr(optimised, inline(always))]
    fn relative<T: Real>(&self, pi: &Vector3<T>) -> Vector3<T> {
        pi - self.rotor.map(T::from_f64)
    }
}

fn require_finite_vector(
    names: [&'static str; 3],
    vector: &Vector3<f64>,
) -> Result<(), SystemError> {
    names.iter().zip(vector).try_for_each(|(name, &value)| require_finite(name, value))
}

impl<T: Real> Hamiltonian<LiePoisson<Se3>, T> for Gyrostat {
    #[inline]
    fn value(&self, Covector(Pair(pi, gamma)): &Se3Dual<T>) -> T {
        let relative = self.relative(pi);
        let height = gamma.dot(&self.center_of_mass.map(T::from_f64));
        relative.dot(&self.moments.angular_velocity(&relative)) * 0.5 + height * self.weight
    }

    #[inline]
    fn differential(&self, Covector(Pair(pi, _)): &Se3Dual<T>) -> Pair<Vector3<T>, Vector3<T>> {
        let force = self.center_of_mass.map(|r| T::from_f64(self.weight * r));
        Pair(self.moments.angular_velocity(&self.relative(pi)), force)
    }

    #[inline]
    fn hessian(&self, mu: &Se3Dual<T>, v: &Se3Dual<T>) -> Option<Pair<Vector3<T>, Vector3<T>>> {
        Some(hessian_by_dual_numbers::<LiePoisson<Se3>, T, _>(self, mu, v))
    }
}
