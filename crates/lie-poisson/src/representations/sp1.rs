//! The group Sp(1) of unit quaternions and its action on quaternions.

use crate::algebras::group::LieGroup;
use crate::groups::su2::Su2;
use crate::representations::representation::{GroupRepresentation, Representation};
use generic_scalars::{Covector, Power, Quaternion, Real, Vector, VectorSpace};
use nalgebra::Vector3;

/// The space H^N as a real vector space of dimension 4N, with ⟨p, q⟩ = Re Σ conj(p) q.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct QuaternionSpace<const N: usize>;

impl<const N: usize> VectorSpace for QuaternionSpace<N> {
    type Point<T: Real> = Power<Quaternion<T>, N>;
}

/// The group Sp(1) ≅ SU(2) of unit quaternions.
///
/// Its Lie algebra su(2) ≅ R³ is embedded in H by ξ ↦ ½ξ, so that the bracket is the cross product:
/// ½ξ ½η − ½η ½ξ = ½(ξ × η).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SP1;

impl LieGroup for SP1 {
    type Algebra = Su2;
    type Element<T: Real> = Quaternion<T>;

    fn algebra(&self) -> Su2 {
        Su2
    }

    #[cfg_attr(optimised, inline(always))]
    fn identity<T: Real>(&self) -> Quaternion<T> {
        Quaternion::one()
    }

    #[cfg_attr(optimised, inline(always))]
    fn compose<T: Real>(&self, g: &Quaternion<T>, h: &Quaternion<T>) -> Quaternion<T> {
        *g * *h
    }

    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, g: &Quaternion<T>) -> Quaternion<T> {
        g.conjugate()
    }

    /// Returns the unit quaternion cos(|ξ|/2) + sin(|ξ|/2) ξ/|ξ|.
    #[cfg_attr(optimised, inline(always))]
    fn exp<T: Real>(&self, xi: &Vector3<T>) -> Quaternion<T> {
        let x = xi.dot(xi) * 0.25;
        Quaternion { scalar: x.stumpff(0), vector: xi * (x.stumpff(1) * 0.5) }
    }

    /// Returns Ad_q ξ = q ξ conj(q).
    #[cfg_attr(optimised, inline(always))]
    fn adjoint<T: Real>(&self, g: &Quaternion<T>, xi: &Vector3<T>) -> Vector3<T> {
        g.sandwich(xi)
    }

    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        g: &Quaternion<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(g.conjugate().sandwich(&mu.0))
    }
}

/// The representation of Sp(1) on H^N by multiplication from the left: ξ v = ½ξ v.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SP1OnQuaternions<const N: usize>;

impl<const N: usize> Representation for SP1OnQuaternions<N> {
    type Algebra = Su2;
    type Space<T: Real> = Power<Quaternion<T>, N>;

    fn algebra(&self) -> Su2 {
        Su2
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Self::Space<T>) -> Self::Space<T> {
        let half = Quaternion { scalar: T::zero(), vector: xi.scaled(T::from_f64(0.5)) };
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| half * v.0[n],
        )
    }

    /// Returns ξᵀ α, which is conj(½ξ) α = −½ξ α in coordinates.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &Vector3<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        -Covector(self.act::<T>(xi, &alpha.0))
    }

    /// Returns the diamond product `v ◇ α` = ½ Im Σ αₙ conj(vₙ).
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &Self::Space<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Vector3<T>> {
        let terms = alpha.0.0.iter().zip(&v.0);
        let sum =
            terms.fold(Vector3::zeros(), |sum, (a, v)| sum + a.imaginary_part_by_conjugate(v));
        Covector(sum * T::from_f64(0.5))
    }
}

impl<const N: usize> GroupRepresentation for SP1OnQuaternions<N> {
    type Group = SP1;

    fn group(&self) -> SP1 {
        SP1
    }

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(&self, g: &Quaternion<T>, v: &Self::Space<T>) -> Self::Space<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| *g * v.0[n],
        )
    }
}
