//! What the satellites on circles and on ellipses share: the energy in a tide, and its differential.

use crate::error::{SystemError, require_finite};
use crate::gyrostat::principal_moments::PrincipalMoments;
use lie_poisson::{Covector, Diagonal, Pair, Power, Real, SO3OnR3, SemidirectAlgebra};
use nalgebra::Vector3;

/// The Lie algebra so(3) ⋉ (R³ ⊕ R³) of a body that sees two directions.
pub type SatelliteAlgebra = SemidirectAlgebra<Diagonal<SO3OnR3, 2>>;

/// An element (Ω, (γ₁, γ₂)) of so(3) ⋉ (R³ ⊕ R³).
pub type SatelliteElement<T = f64> = Pair<Vector3<T>, Power<Vector3<T>, 2>>;

/// A point (Π, (Γ₁, Γ₂)) of (so(3) ⋉ (R³ ⊕ R³))∗.
pub type SatelliteDual<T = f64> = Covector<SatelliteElement<T>>;

/// A rigid body in a tide GM/r³, seen in a frame that turns at the rate n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GravityGradient {
    inertia: Vector3<f64>,
    moments: PrincipalMoments,
}

impl GravityGradient {
    /// Creates a body from its principal moments (kg m²) and the strongest tide in which it will be (1/s²).
    pub(crate) fn new(inertia: Vector3<f64>, strongest: f64) -> Result<Self, SystemError> {
        let moments = PrincipalMoments::new(&inertia)?;
        for moment in &inertia {
            require_finite("torque of the tide, 3 GM/r³ times a moment", 3.0 * strongest * moment)?;
        }
        Ok(Self { inertia, moments })
    }

    /// Returns I⁻¹Π.
    pub(crate) fn angular_velocity<T: Real>(&self, pi: &Vector3<T>) -> Vector3<T> {
        self.moments.angular_velocity(pi)
    }

    /// Returns the point at which the body turns at the relative velocity w against a frame with the rate n.
    pub(crate) fn momentum<T: Real>(
        &self,
        [radial, normal]: [Vector3<T>; 2],
        relative: &Vector3<T>,
        rate: T,
    ) -> SatelliteDual<T> {
        let pi = self.weighted(&(relative + normal * rate));
        Covector(Pair(pi, Power([radial, normal])))
    }

    /// Returns I v.
    fn weighted<T: Real>(&self, v: &Vector3<T>) -> Vector3<T> {
        v.zip_map(&self.inertia, |v, moment| v * moment)
    }

    /// Returns ½ Π·I⁻¹Π − n Π·Γ₂ + (3/2) k Γ₁·IΓ₁ with the weights n and k.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn energy<T: Real>(&self, mu: &SatelliteDual<T>, rate: T, tide: T) -> T {
        let Covector(Pair(pi, _)) = mu;
        pi.dot(&self.moments.angular_velocity(pi)) * 0.5 + self.potential(mu, rate, tide)
    }

    /// Returns −n Π·Γ₂ + (3/2) k Γ₁·IΓ₁, which is ∂h/∂t if n and k are their own derivatives with respect to time.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn potential<T: Real>(&self, mu: &SatelliteDual<T>, rate: T, tide: T) -> T {
        let Covector(Pair(pi, Power([radial, normal]))) = mu;
        radial.dot(&self.weighted(radial)) * tide * 1.5 - pi.dot(normal) * rate
    }

    /// Returns (I⁻¹Π − n Γ₂, (3 k IΓ₁, −n Π)).
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn differential<T: Real>(
        &self,
        Covector(Pair(pi, Power([radial, normal]))): &SatelliteDual<T>,
        rate: T,
        tide: T,
    ) -> SatelliteElement<T> {
        let relative = self.moments.angular_velocity(pi) - normal * rate;
        Pair(relative, Power([self.weighted(radial) * (tide * 3.0), pi * -rate]))
    }
}
