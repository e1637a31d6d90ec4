//! The Lie algebra so(2) and the group SO(2).

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::LieGroup;
use generic_scalars::{Real, Vector};
use nalgebra::{Matrix2, Vector1};

/// The abelian Lie algebra so(2) ≅ R, in which ω stands for the matrix [0 −ω; ω 0].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct So2;

impl LieAlgebra for So2 {
    type Element<T: Real> = Vector1<T>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, _: &Vector1<T>, _: &Vector1<T>) -> Vector1<T> {
        Vector::zero()
    }
}

/// The group SO(2) of rotations of the plane, given by their matrices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SO2;

impl LieGroup for SO2 {
    type Algebra = So2;
    type Element<T: Real> = Matrix2<T>;

    fn algebra(&self) -> So2 {
        So2
    }

    #[cfg_attr(optimised, inline(always))]
    fn identity<T: Real>(&self) -> Matrix2<T> {
        Matrix2::identity()
    }

    #[cfg_attr(optimised, inline(always))]
    fn compose<T: Real>(&self, g: &Matrix2<T>, h: &Matrix2<T>) -> Matrix2<T> {
        g * h
    }

    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, g: &Matrix2<T>) -> Matrix2<T> {
        g.transpose()
    }

    /// Returns the rotation matrix [cos ω −sin ω; sin ω cos ω], with ω in radians.
    #[cfg_attr(optimised, inline(always))]
    fn exp<T: Real>(&self, xi: &Vector1<T>) -> Matrix2<T> {
        let x = xi.x * xi.x;
        let (cosine, sine) = (x.stumpff(0), xi.x * x.stumpff(1));
        Matrix2::new(cosine, -sine, sine, cosine)
    }

    /// Returns ξ itself: Ad_g is the identity.
    #[cfg_attr(optimised, inline(always))]
    fn adjoint<T: Real>(&self, _: &Matrix2<T>, xi: &Vector1<T>) -> Vector1<T> {
        *xi
    }
}
