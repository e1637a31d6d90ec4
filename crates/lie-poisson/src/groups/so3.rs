//! The Lie algebra so(3) and the rotation group SO(3).

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::LieGroup;
use generic_scalars::{Covector, Real, cross};
use nalgebra::{Matrix3, Vector3};

/// The Lie algebra so(3) ≅ R³ with [ξ, η] = ξ × η.
///
/// The coordinates refer to the basis hat(e₁), hat(e₂), hat(e₃), where hat(ξ) v = ξ × v. The dot product of
/// coordinates is ⟨ξ, η⟩ = ½ tr(hat(ξ)ᵀ hat(η)).
///
/// Source: Ohsawa 2019, Appendix A.1 and eq. (A.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct So3;

impl So3 {
    /// Applies the hat map: returns the matrix hat(ξ) with hat(ξ) v = ξ × v.
    ///
    /// Source: Ohsawa 2019, Appendix A.1.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use nalgebra::Vector3;
    /// let (xi, v) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
    /// assert_eq!(So3.hat(&xi) * v, xi.cross(&v));
    /// ```
    #[inline]
    #[rustfmt::skip]
    pub fn hat<T: Real>(&self, xi: &Vector3<T>) -> Matrix3<T> {
        let zero = T::zero();
        Matrix3::new( zero, -xi.z,  xi.y,
                      xi.z,  zero, -xi.x,
                     -xi.y,  xi.x,  zero)
    }
}

impl LieAlgebra for So3 {
    type Element<T: Real> = Vector3<T>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        cross(xi, eta)
    }

    /// Returns the coadjoint operator `ad∗_ξ μ = μ × ξ`.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &Vector3<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(cross(&mu.0, xi))
    }
}

/// The rotation group SO(3), with rotations given by their matrices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SO3;

impl LieGroup for SO3 {
    type Algebra = So3;
    type Element<T: Real> = Matrix3<T>;

    fn algebra(&self) -> So3 {
        So3
    }

    #[cfg_attr(optimised, inline(always))]
    fn identity<T: Real>(&self) -> Matrix3<T> {
        Matrix3::identity()
    }

    #[cfg_attr(optimised, inline(always))]
    fn compose<T: Real>(&self, g: &Matrix3<T>, h: &Matrix3<T>) -> Matrix3<T> {
        g * h
    }

    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, g: &Matrix3<T>) -> Matrix3<T> {
        g.transpose()
    }

    /// Returns exp ξ = I + c₁(|ξ|²) X + c₂(|ξ|²) X² with X = hat(ξ), which is Rodrigues' formula.
    ///
    /// c₁ and c₂ are [Stumpff functions](Real::stumpff). Angles are in radians.
    #[cfg_attr(optimised, inline(always))]
    fn exp<T: Real>(&self, xi: &Vector3<T>) -> Matrix3<T> {
        let (hat, x) = (So3.hat(xi), xi.dot(xi));
        Matrix3::identity() + hat * x.stumpff(1) + hat * hat * x.stumpff(2)
    }

    /// Returns the rotated vector `Ad_R ξ = R ξ`.
    #[cfg_attr(optimised, inline(always))]
    fn adjoint<T: Real>(&self, g: &Matrix3<T>, xi: &Vector3<T>) -> Vector3<T> {
        g * xi
    }

    /// Returns the rotated vector `Ad∗_R μ = Rᵀ μ`.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        g: &Matrix3<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(g.tr_mul(&mu.0))
    }
}
