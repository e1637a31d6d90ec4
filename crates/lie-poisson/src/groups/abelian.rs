//! The space R^N as an abelian Lie algebra and as a Lie group.

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::LieGroup;
use generic_scalars::{Real, RealSpace, Vector};
use nalgebra::SVector;

/// The abelian Lie algebra R^N, with [ξ, η] = 0.
impl<const N: usize> LieAlgebra for RealSpace<N> {
    type Element<T: Real> = SVector<T, N>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, _: &SVector<T, N>, _: &SVector<T, N>) -> SVector<T, N> {
        Vector::zero()
    }
}

/// The Lie group R^N of translations.
impl<const N: usize> LieGroup for RealSpace<N> {
    type Algebra = Self;
    type Element<T: Real> = SVector<T, N>;

    fn algebra(&self) -> Self {
        *self
    }

    #[cfg_attr(optimised, inline(always))]
    fn identity<T: Real>(&self) -> SVector<T, N> {
        Vector::zero()
    }

    #[cfg_attr(optimised, inline(always))]
    fn compose<T: Real>(&self, g: &SVector<T, N>, h: &SVector<T, N>) -> SVector<T, N> {
        g + h
    }

    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, g: &SVector<T, N>) -> SVector<T, N> {
        -g
    }

    /// Returns ξ itself: exp is the identity.
    #[cfg_attr(optimised, inline(always))]
    fn exp<T: Real>(&self, xi: &SVector<T, N>) -> SVector<T, N> {
        *xi
    }

    /// Returns ξ itself: Ad_g is the identity.
    #[cfg_attr(optimised, inline(always))]
    fn adjoint<T: Real>(&self, _: &SVector<T, N>, xi: &SVector<T, N>) -> SVector<T, N> {
        *xi
    }
}
