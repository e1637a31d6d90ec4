//! Dual quaternions as multipliers: [`DualQuaternions`].

use crate::multipliers::multiplier::{InvertibleMultipliers, Multipliers};
use lie_poisson::{
    Covector, LiePoisson, Pair, Quaternion, Real, SO3OnR3, Se3, Se3Dual, SemidirectAlgebra, Vector,
    cross, dot,
};
use nalgebra::Vector3;

/// Dual quaternions Q + εN as multipliers, for se(3)∗ with the minus bracket and M: T∗C² → se(3)∗.
///
/// With (Ω, γ) = dh,
///
/// ```text
/// dQ/dt = −½ Ω Q,    dN/dt = −½ Ω N − 2γ Q,    N conj(Q) = x₀ + x
/// Γ = Q Γ₀ conj(Q),    Π = Q Π₀ conj(Q) + (x × Γ + x₀ Γ)/(2|Q|²) = Im((Q Π₀ + ½ N Γ₀) conj(Q))
/// ```
///
/// where χ = Qχ₀ − iNψ₀ and ψ = Qψ₀ (quaternions act on C² by u ↦ −i u·σ). The quadratic invariants |Q|² =
/// 1 and x₀ = 0 are those of unit dual quaternions, which form the double cover of SE(3).
///
/// Source of dual quaternions: E. Study, *Geometrie der Dynamen* (1903).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DualQuaternions;

impl InvertibleMultipliers for DualQuaternions {}

impl Multipliers for DualQuaternions {
    type Space = LiePoisson<Se3>;
    type Multiplier<T: Real> = Pair<Quaternion<T>, Quaternion<T>>;

    fn space(&self) -> LiePoisson<Se3> {
        LiePoisson::minus(SemidirectAlgebra(SO3OnR3))
    }

    #[cfg_attr(optimised, inline(always))]
    fn one<T: Real>(&self) -> Self::Multiplier<T> {
        Pair(Quaternion::one(), Vector::zero())
    }

    #[cfg_attr(optimised, inline(always))]
    fn generate<T: Real>(
        &self,
        dh: &Pair<Vector3<T>, Vector3<T>>,
        q: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        let turn = dh.0 * T::from_f64(-0.5);
        let push = dh.1 * T::from_f64(-2.0);
        let times = Quaternion::imaginary_times;
        Pair(times(&turn, &q.0), times(&turn, &q.1) + times(&push, &q.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn transport<T: Real>(&self, q: &Self::Multiplier<T>, mu: &Se3Dual<T>) -> Se3Dual<T> {
        let (Pair(q, n), Covector(Pair(pi, gamma))) = (q, mu);
        let half = gamma * T::from_f64(0.5);
        let moved = q.times_imaginary(pi) + n.times_imaginary(&half);
        let turned = q.times_imaginary(gamma);
        Se3Dual::new(moved.imaginary_part_by_conjugate(q), turned.imaginary_part_by_conjugate(q))
    }

    /// Returns the change of μ under the unit dual quaternion near Q + εN, which has |Q|² = 1 and x₀ = 0.
    // Without the attribute, the compiler does not inline it in steps over SIMD lanes, which costs a twentieth of
    // their time.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint_change<T: Real>(&self, q: &Self::Multiplier<T>, mu: &Se3Dual<T>) -> Se3Dual<T> {
        let (Pair(q, n), Covector(Pair(pi, gamma))) = (q, mu);
        let change = q.rotation_change(gamma);
        let x = (*n * q.conjugate()).vector * (T::from_f64(0.5) / q.norm_squared());
        Se3Dual::new(q.rotation_change(pi) + cross(&x, &(gamma + change)), change)
    }

    /// Returns the product (Q + εN)(A + εB) = QA + ε(QB + NA).
    #[cfg_attr(optimised, inline(always))]
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Pair(q.0 * b.0, q.0 * b.1 + q.1 * b.0)
    }

    /// Returns (A + εB)⁻¹ = A′/|A|² + ε (B′ − 2 ⟨A, B⟩ A′/|A|²)/|A|² for A ≠ 0, where A′ = conj(A) and B′ =
    /// conj(B).
    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, b: &Self::Multiplier<T>) -> Self::Multiplier<T> {
        let Pair(a, b) = b;
        let scale = T::one() / a.norm_squared();
        let turn = a.conjugate().scaled(scale);
        let along = a.scalar * b.scalar + dot(&a.vector, &b.vector);
        Pair(turn, b.conjugate().scaled(scale) - turn.scaled((along + along) * scale))
    }
}
