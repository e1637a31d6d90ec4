//! Quaternions as multipliers: [`Quaternions`].

use crate::multipliers::multiplier::{InvertibleMultipliers, Multipliers};
use lie_poisson::{Covector, LiePoisson, Quaternion, Real, So3, Vector};
use nalgebra::Vector3;

/// Quaternions as multipliers, for so(3)∗ with the minus bracket and the Hopf map:
///
/// ```text
/// dQ/dt = −½ Ω Q,    Π = Q Π₀ conj(Q)
/// ```
///
/// Unit quaternions rotate Π₀. A step with the multiplier Q, which rotates by R_Q, changes the attitude of the body to
/// Rₙ₊₁ = Rₙ R_Qᵀ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Quaternions;

impl InvertibleMultipliers for Quaternions {}

impl Multipliers for Quaternions {
    type Space = LiePoisson<So3>;
    type Multiplier<T: Real> = Quaternion<T>;

    fn space(&self) -> LiePoisson<So3> {
        LiePoisson::minus(So3)
    }

    #[cfg_attr(optimised, inline(always))]
    fn one<T: Real>(&self) -> Quaternion<T> {
        Quaternion::one()
    }

    #[cfg_attr(optimised, inline(always))]
    fn generate<T: Real>(&self, omega: &Vector3<T>, q: &Quaternion<T>) -> Quaternion<T> {
        Quaternion::imaginary_times(&(omega * T::from_f64(-0.5)), q)
    }

    #[cfg_attr(optimised, inline(always))]
    fn transport<T: Real>(
        &self,
        q: &Quaternion<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(q.sandwich(&mu.0))
    }

    /// Returns the change of μ under the rotation by Q/|Q|.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Quaternion<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(q.rotation_change(&mu.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn product<T: Real>(&self, q: &Quaternion<T>, b: &Quaternion<T>) -> Quaternion<T> {
        *q * *b
    }

    /// Returns B⁻¹ = conj(B)/|B|² for any B ≠ 0.
    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, b: &Quaternion<T>) -> Quaternion<T> {
        b.conjugate().scaled(T::one() / b.norm_squared())
    }
}
