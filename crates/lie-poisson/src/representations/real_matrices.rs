//! The defining representations of the classical groups of real matrices.

use crate::groups::sl2::{SL2, Sl2};
use crate::groups::so2::{SO2, So2};
use crate::groups::so3::{SO3, So3};
use crate::representations::representation::{GroupRepresentation, Representation};
use generic_scalars::{Covector, Real, cross};
use nalgebra::{Matrix2, Matrix3, Vector1, Vector2, Vector3};

/// The representation of SO(3) on R³ by rotation: ξ v = ξ × v.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SO3OnR3;

impl Representation for SO3OnR3 {
    type Algebra = So3;
    type Space<T: Real> = Vector3<T>;

    fn algebra(&self) -> So3 {
        So3
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector3<T>) -> Vector3<T> {
        cross(xi, v)
    }

    /// Returns the transposed action `ξᵀ α = α × ξ`.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &Vector3<T>,
        alpha: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(cross(&alpha.0, xi))
    }

    /// Returns the diamond product `v ◇ α = v × α`.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &Vector3<T>,
        alpha: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(cross(v, &alpha.0))
    }
}

impl GroupRepresentation for SO3OnR3 {
    type Group = SO3;

    fn group(&self) -> SO3 {
        SO3
    }

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(&self, g: &Matrix3<T>, v: &Vector3<T>) -> Vector3<T> {
        g * v
    }

    /// Returns φ + c₂ ξ×φ + c₃ ξ×(ξ×φ), with Stumpff functions of |ξ|².
    #[cfg_attr(optimised, inline(always))]
    fn exp_integral<T: Real>(&self, xi: &Vector3<T>, phi: &Vector3<T>) -> Vector3<T> {
        let (x, turned) = (xi.dot(xi), xi.cross(phi));
        phi + turned * x.stumpff(2) + xi.cross(&turned) * x.stumpff(3)
    }
}

/// The representation of SO(2) on R² by rotation: ω v = ω (−v₂, v₁).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SO2OnR2;

impl Representation for SO2OnR2 {
    type Algebra = So2;
    type Space<T: Real> = Vector2<T>;

    fn algebra(&self) -> So2 {
        So2
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &Vector1<T>, v: &Vector2<T>) -> Vector2<T> {
        Vector2::new(-v.y, v.x) * xi.x
    }

    /// Returns the transposed action `ωᵀ α = ω (α₂, −α₁)`.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &Vector1<T>,
        alpha: &Covector<Vector2<T>>,
    ) -> Covector<Vector2<T>> {
        Covector(Vector2::new(alpha.0.y, -alpha.0.x) * xi.x)
    }

    /// Returns the diamond product `v ◇ α = v₁α₂ − v₂α₁`.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &Vector2<T>,
        alpha: &Covector<Vector2<T>>,
    ) -> Covector<Vector1<T>> {
        Covector(Vector1::new(v.x * alpha.0.y - v.y * alpha.0.x))
    }
}

impl GroupRepresentation for SO2OnR2 {
    type Group = SO2;

    fn group(&self) -> SO2 {
        SO2
    }

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(&self, g: &Matrix2<T>, v: &Vector2<T>) -> Vector2<T> {
        g * v
    }

    /// Returns c₁(ω²) φ + c₂(ω²) ω (−φ₂, φ₁), with Stumpff functions.
    #[cfg_attr(optimised, inline(always))]
    fn exp_integral<T: Real>(&self, xi: &Vector1<T>, phi: &Vector2<T>) -> Vector2<T> {
        let x = xi.x * xi.x;
        phi * x.stumpff(1) + self.act(xi, phi) * x.stumpff(2)
    }
}

/// The representation of SL(2, R) on R² by matrix multiplication.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SL2OnR2;

impl Representation for SL2OnR2 {
    type Algebra = Sl2;
    type Space<T: Real> = Vector2<T>;

    fn algebra(&self) -> Sl2 {
        Sl2
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector2<T>) -> Vector2<T> {
        Sl2.matrix(xi) * v
    }

    /// Returns the transposed action `ξᵀ α` by the transposed matrix.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &Vector3<T>,
        alpha: &Covector<Vector2<T>>,
    ) -> Covector<Vector2<T>> {
        Covector(Sl2.matrix(xi).transpose() * alpha.0)
    }

    /// Returns the diamond product `v ◇ α = (v₁α₁ − v₂α₂, v₂α₁, v₁α₂)`.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &Vector2<T>,
        alpha: &Covector<Vector2<T>>,
    ) -> Covector<Vector3<T>> {
        let Covector(a) = alpha;
        Covector(Vector3::new(v.x * a.x - v.y * a.y, v.y * a.x, v.x * a.y))
    }
}

impl GroupRepresentation for SL2OnR2 {
    type Group = SL2;

    fn group(&self) -> SL2 {
        SL2
    }

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(&self, g: &Matrix2<T>, v: &Vector2<T>) -> Vector2<T> {
        g * v
    }

    /// Returns c₁(det ξ) φ + c₂(det ξ) ξφ, since ξ² = −(det ξ) I.
    #[cfg_attr(optimised, inline(always))]
    fn exp_integral<T: Real>(&self, xi: &Vector3<T>, phi: &Vector2<T>) -> Vector2<T> {
        let x = Sl2.determinant(xi);
        phi * x.stumpff(1) + self.act(xi, phi) * x.stumpff(2)
    }
}
