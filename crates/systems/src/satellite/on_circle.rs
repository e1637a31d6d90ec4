//! A satellite on a circular orbit: [`Satellite`].

use crate::error::SystemError;
use crate::satellite::gravity_gradient::{
    GravityGradient, SatelliteAlgebra, SatelliteDual, SatelliteElement,
};
use crate::satellite::kepler_orbit::require_rate;
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Pair, Power, Real, hessian_by_dual_numbers};
use nalgebra::Vector3;

/// A rigid satellite on a circular orbit, whose attitude is turned by the gradient of gravity.
///
/// It is a Hamiltonian on (so(3) ⋉ (R³ ⊕ R³))∗ with the minus bracket. In the frame of the body, Π is the angular
/// momentum against the stars (kg m²/s), Γ₁ the direction from the centre of attraction to the satellite, and Γ₂ the
/// normal of the orbit. With the principal moments I and the angular velocity n of the orbit, for which n² = GM/r³,
///
/// ```text
/// h = ½ Π·I⁻¹Π − n Π·Γ₂ + (3/2) n² Γ₁·IΓ₁,    Ω = I⁻¹Π
/// dΠ/dt = Π × Ω + 3n² Γ₁ × IΓ₁,    dΓᵢ/dt = Γᵢ × (Ω − n Γ₂)
/// ```
///
/// The energy h is conserved: it is Jacobi's integral, the energy in the frame that turns with the orbit. The Casimirs
/// are |Γ₁|², Γ₁·Γ₂ and |Γ₂|², which are 1, 0 and 1 for two directions at right angles. The size of the satellite
/// against its distance is neglected, so that the attitude does not act on the orbit.
///
/// A satellite may stay at rest relative to the orbit with its principal axes along Γ₁, Γ₂ and Γ₂ × Γ₁. With moments
/// `I_r`, `I_n` and `I_t` about these, this is stable if `I_n` > `I_t` > `I_r`: a long boom points to the centre. It
/// then librates in the plane of the orbit with the angular frequency n √(3 (`I_t` − `I_r`)/`I_n`).
///
/// Source: P. C. Hughes, *Spacecraft Attitude Dynamics* (1986), ch. 9; L.-S. Wang, P. S. Krishnaprasad & J. H.
/// Maddocks,
/// *Hamiltonian dynamics of a rigid body in a central gravitational field*, Celest. Mech. Dyn. Astron. 50 (1991).
///
/// # Example
/// A boom that is turned by 0.1 rad from the vertical, at rest relative to the orbit, is turned back. Jacobi's integral
/// is conserved up to the error of the method:
/// ```
/// use lie_poisson_systems::prelude::*;
/// // the boom along e₃, the normal along e₂
/// let satellite = Satellite::new(Vector3::new(1.0, 1.1, 0.2), 1e-3)?;
/// let radial = Vector3::new(0.1_f64.sin(), 0.0, 0.1_f64.cos());
/// let start = satellite.momentum([radial, Vector3::y()], &Vector3::zeros());
/// let gauss = Collective::new(RungeKutta::gauss(2)?, TWO_FIELDS, satellite);
/// let quarter = std::f64::consts::FRAC_PI_2 / (1e-3 * (3.0_f64 * 0.8 / 1.1).sqrt());
/// let end = gauss.after(&start, quarter / 20.0, 20)?.momentum;
/// let Covector(Pair(_, Power([radial, normal]))) = end;
/// assert!(radial.x.abs() < 1e-3 && (normal - Vector3::y()).norm() < 1e-14);
/// assert!((satellite.value(&end) / satellite.value(&start) - 1.0).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Satellite {
    body: GravityGradient,
    rate: f64,
}

impl Satellite {
    /// Creates a satellite from its principal moments I₁, I₂, I₃ (kg m²) and the angular velocity n of its orbit
    /// (rad/s).
    ///
    /// # Errors
    /// Returns [`SystemError`] unless the moments are positive and obey the triangle inequality, n and n² are positive,
    /// and every number is finite, including the inverses of the moments and 3n² I.
    pub fn new(inertia: Vector3<f64>, rate: f64) -> Result<Self, SystemError> {
        require_rate("angular velocity of the orbit", "its square", rate)?;
        Ok(Self { body: GravityGradient::new(inertia, rate * rate)?, rate })
    }

    /// Returns the point (I(w + n Γ₂), Γ₁, Γ₂) of a satellite that sees the directions Γ₁ and Γ₂, and turns at the
    /// angular velocity w relative to the orbit (rad/s).
    pub fn momentum<T: Real>(
        &self,
        directions: [Vector3<T>; 2],
        relative: &Vector3<T>,
    ) -> SatelliteDual<T> {
        self.body.momentum(directions, relative, T::from_f64(self.rate))
    }

    /// Returns the angular velocity against the stars, I⁻¹Π, rad/s.
    pub fn angular_velocity<T: Real>(&self, mu: &SatelliteDual<T>) -> Vector3<T> {
        self.body.angular_velocity(&mu.0.0)
    }

    /// Returns the Casimirs |Γ₁|², Γ₁·Γ₂ and |Γ₂|², dimensionless.
    pub fn casimirs<T: Real>(mu: &SatelliteDual<T>) -> [T; 3] {
        let Covector(Pair(_, Power([radial, normal]))) = mu;
        [radial.dot(radial), radial.dot(normal), normal.dot(normal)]
    }

    /// Returns n and n².
    fn weights<T: Real>(&self) -> [T; 2] {
        [self.rate, self.rate * self.rate].map(T::from_f64)
    }
}

impl<T: Real> Hamiltonian<LiePoisson<SatelliteAlgebra>, T> for Satellite {
    #[inline]
    fn value(&self, mu: &SatelliteDual<T>) -> T {
        let [rate, tide] = self.weights();
        self.body.energy(mu, rate, tide)
    }

    #[inline]
    fn differential(&self, mu: &SatelliteDual<T>) -> SatelliteElement<T> {
        let [rate, tide] = self.weights();
        self.body.differential(mu, rate, tide)
    }

    #[inline]
    fn hessian(&self, mu: &SatelliteDual<T>, v: &SatelliteDual<T>) -> Option<SatelliteElement<T>> {
        Some(hessian_by_dual_numbers::<LiePoisson<SatelliteAlgebra>, T, _>(self, mu, v))
    }
}
