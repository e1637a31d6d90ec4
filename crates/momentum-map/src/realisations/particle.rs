//! The realisation of the level Π·Γ = 0 of se(3)∗ on T∗R³.

use crate::actions::derived_actions::Opposite;
use crate::actions::represented_actions::AffineAction;
use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::momentum_map::MomentumMap;
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetPoint};
use crate::phase_spaces::cotangent::Cotangent;
use lie_poisson::{Covector, Mask, Pair, Real, SO3OnR3, Vector, squaring_scale};

/// The momentum map of the right action q ↦ Rᵀ(q − a) of SE(3) on R³, lifted to T∗R³:
///
/// ```text
/// M(q, p) = −(q × p, p),    so that Π ⊥ Γ
/// ```
///
/// The image is only the level Π·Γ = 0, so that the map cannot be used for the heavy top. The fibres are the lines
/// q + sp, with momentum ½|p|².
///
/// Source: Ohsawa 2019, Remark 2.1.
///
/// # Example
/// ```
/// use lie_poisson::Se3Dual;
/// use momentum_map::{Lift, PARTICLE};
/// use nalgebra::Vector3;
/// // the upright spinning top has no lift
/// assert!(PARTICLE.lift::<f64>(&Se3Dual::new(Vector3::z(), Vector3::z())).is_err());
/// assert!(PARTICLE.lift::<f64>(&Se3Dual::new(Vector3::x(), Vector3::z())).is_ok());
/// ```
pub type ParticleRealisation = MomentumMap<Opposite<AffineAction<SO3OnR3>>>;

/// The realisation T∗R³ → se(3)∗ of the level Π·Γ = 0, with the minus bracket.
pub const PARTICLE: ParticleRealisation = MomentumMap(Opposite(AffineAction(SO3OnR3)));

/// The greatest deviation of Π and Γ from a right angle, in radians, which allows for the
/// round-off of a few thousand operations.
const RIGHT_ANGLE_TOLERANCE: f64 = 1e-12;

impl Lift for ParticleRealisation {
    /// Returns (q, p) = (Γ × Π/|Γ|², −Γ), the point of the fibre nearest to the origin.
    ///
    /// # Errors
    /// Returns [`LiftError`] unless Π ⊥ Γ to within 10⁻¹², Γ ≠ 0, both are finite, and neither |Π|/|Γ| nor
    /// |Π| overflows.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError> {
        let Covector(Pair(pi, gamma)) =
            LiftError::unless_finite(*mu, "μ", mu.max_abs(), "Π and Γ must be finite")?;
        let (pi_scale, gamma_scale) = (squaring_scale(&pi), squaring_scale(&gamma));
        let (pi_unit, gamma_unit) = (pi * pi_scale, gamma * gamma_scale);
        let square = gamma_unit.dot(&gamma_unit);
        if square.at_most(T::zero()).any() {
            return Err(LiftError {
                quantity: "Γ",
                value: 0.0,
                reason: "Γ must be different from 0",
            });
        }
        let sizes = pi_unit.max_norm() * gamma_unit.max_norm();
        let cosine = pi_unit.dot(&gamma_unit).magnitude();
        if !cosine.at_most(sizes * RIGHT_ANGLE_TOLERANCE).all() {
            let reason = "Π and Γ must be perpendicular";
            let value = (cosine / sizes).max_abs();
            return Err(LiftError { quantity: "cos(Π, Γ)", value, reason });
        }
        let q = gamma_unit.cross(&pi_unit) / square * (gamma_scale / pi_scale);
        let z = Cotangent::new(q, Covector(-gamma));
        let range = Pair(z, self.apply::<T>(&z));
        let reason = "|Π|/|Γ| and |Π| must be below 1.7e308";
        Ok(LiftError::unless_finite(range, "Π", pi.max_abs(), reason)?.0)
    }
}

impl FibreSymmetry for ParticleRealisation {
    const COUNT: usize = 1;

    /// Returns the point (q + sp, p).
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        if index > 0 { *z } else { Cotangent { q: z.q + z.p.0 * s, ..*z } }
    }

    /// Returns the momentum ½|p|².
    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<Self, T>) -> T {
        if index > 0 { T::zero() } else { z.p.0.dot(&z.p.0) * 0.5 }
    }
}
