//! The Lie algebra sl(2, R) ≅ so(2, 1) and the group SL(2, R).

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::LieGroup;
use generic_scalars::{Covector, Real};
use nalgebra::{Matrix2, Vector3};

/// The Lie algebra sl(2, R) of traceless matrices, ξ = [a b; c −a] with coordinates (a, b, c).
///
/// ```text
/// [ξ, ξ′] = (bc′ − cb′, 2(ab′ − ba′), 2(ca′ − ac′))
/// ```
///
/// It is isomorphic to so(2, 1): its Killing form is 8(a² + bc), of signature (2, 1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sl2;

impl Sl2 {
    /// Returns the matrix [a b; c −a] of the coordinates (a, b, c).
    ///
    /// ```
    /// use lie_poisson::{LieAlgebra, Sl2};
    /// use nalgebra::Vector3;
    /// let (xi, eta) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
    /// let (a, b) = (Sl2.matrix(&xi), Sl2.matrix(&eta));
    /// assert_eq!(a * b - b * a, Sl2.matrix(&Sl2.bracket(&xi, &eta)));
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub fn matrix<T: Real>(&self, xi: &Vector3<T>) -> Matrix2<T> {
        Matrix2::new(xi.x, xi.y, xi.z, -xi.x)
    }

    /// Returns the coordinates of a traceless matrix; for any other matrix, those of its traceless part.
    #[cfg_attr(optimised, inline(always))]
    pub fn coordinates<T: Real>(&self, xi: &Matrix2<T>) -> Vector3<T> {
        Vector3::new((xi.m11 - xi.m22) * 0.5, xi.m12, xi.m21)
    }

    /// Returns det ξ = −a² − bc, positive for elliptic and negative for hyperbolic elements.
    ///
    /// It satisfies ξ² = −(det ξ) I.
    #[cfg_attr(optimised, inline(always))]
    pub fn determinant<T: Real>(&self, xi: &Vector3<T>) -> T {
        -(xi.x * xi.x + xi.y * xi.z)
    }
}

impl LieAlgebra for Sl2 {
    type Element<T: Real> = Vector3<T>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        let c = xi.cross(eta);
        Vector3::new(c.x, c.z + c.z, c.y + c.y)
    }

    /// Returns ad∗_ξ μ = (α, 2γ, 2β) × ξ for μ = (α, β, γ).
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &Vector3<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        let Covector(m) = mu;
        Covector(Vector3::new(m.x, m.z + m.z, m.y + m.y).cross(xi))
    }
}

/// The group SL(2, R) of 2×2 matrices of determinant 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SL2;

impl LieGroup for SL2 {
    type Algebra = Sl2;
    type Element<T: Real> = Matrix2<T>;

    fn algebra(&self) -> Sl2 {
        Sl2
    }

    #[cfg_attr(optimised, inline(always))]
    fn identity<T: Real>(&self) -> Matrix2<T> {
        Matrix2::identity()
    }

    #[cfg_attr(optimised, inline(always))]
    fn compose<T: Real>(&self, g: &Matrix2<T>, h: &Matrix2<T>) -> Matrix2<T> {
        g * h
    }

    /// Returns the inverse of g, its adjugate matrix.
    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, g: &Matrix2<T>) -> Matrix2<T> {
        Matrix2::new(g.m22, -g.m12, -g.m21, g.m11)
    }

    /// Returns exp ξ = c₀(det ξ) I + c₁(det ξ) ξ, with the [Stumpff functions](Real::stumpff) c₀ and c₁.
    ///
    /// These are circular functions for elliptic elements and hyperbolic ones for hyperbolic elements,
    /// without a branch.
    #[cfg_attr(optimised, inline(always))]
    fn exp<T: Real>(&self, xi: &Vector3<T>) -> Matrix2<T> {
        let x = Sl2.determinant(xi);
        Matrix2::from_diagonal_element(x.stumpff(0)) + Sl2.matrix(xi) * x.stumpff(1)
    }

    /// Returns the coordinates of `Ad_g ξ = g ξ g⁻¹`.
    #[cfg_attr(optimised, inline(always))]
    fn adjoint<T: Real>(&self, g: &Matrix2<T>, xi: &Vector3<T>) -> Vector3<T> {
        Sl2.coordinates(&(g * Sl2.matrix(xi) * self.inverse(g)))
    }
}
