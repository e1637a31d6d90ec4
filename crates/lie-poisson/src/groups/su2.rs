//! The Lie algebra su(2) and the group SU(2).

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::LieGroup;
use crate::groups::so3::{SO3, So3};
use generic_scalars::{Covector, Real};
use nalgebra::{Matrix2, Matrix3, Vector3};
use num_complex::Complex;

/// The Lie algebra su(2) ≅ R³ with the basis e_j = −(i/2) σ_j, in which the bracket is the cross product.
///
/// The dot product of coordinates is ⟨ξ, η⟩ = 2 tr(ξ∗ η), which also identifies su(2)∗ with su(2).
///
/// Source: Ohsawa 2019, Appendix A.1 and eq. (A.1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Su2;

impl Su2 {
    /// Returns the matrix Σ ξ_j e_j = −(i/2) ξ·σ of the coordinates ξ. Source: Ohsawa 2019, Appendix A.1.
    ///
    /// ```
    /// use lie_poisson::Su2;
    /// use nalgebra::Vector3;
    /// let (xi, eta) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
    /// let (a, b) = (Su2.matrix(&xi), Su2.matrix(&eta));
    /// // [e_i, e_j] is e_i × e_j, and ⟨ξ, η⟩ = 2 tr(ξ* η) = ξ·η
    /// assert_eq!(a * b - b * a, Su2.matrix(&xi.cross(&eta)));
    /// let trace = (a.map(|z| z.conj()).transpose() * b).trace();
    /// assert_eq!(2.0 * trace.re, xi.dot(&eta));
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub fn matrix<T: Real>(&self, xi: &Vector3<T>) -> Matrix2<Complex<T>> {
        let half = xi * T::from_f64(0.5);
        let entry = |re, im| Complex { re, im };
        Matrix2::new(
            entry(T::zero(), -half.z),
            entry(-half.y, -half.x),
            entry(half.y, -half.x),
            entry(T::zero(), half.z),
        )
    }

    /// Returns the coordinates `ξ_j = ⟨e_j, ξ⟩ = 2 tr(e_j∗ ξ)` of a matrix in su(2).
    ///
    /// For a matrix outside of su(2) they are those of its orthogonal projection to su(2).
    ///
    /// ```
    /// use lie_poisson::Su2;
    /// use nalgebra::Vector3;
    /// let xi = Vector3::new(1.0, 2.0, 3.0);
    /// assert_eq!(Su2.coordinates(&Su2.matrix(&xi)), xi);
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub fn coordinates<T: Real>(&self, xi: &Matrix2<Complex<T>>) -> Vector3<T> {
        Vector3::new(-(xi.m12.im + xi.m21.im), xi.m21.re - xi.m12.re, xi.m22.im - xi.m11.im)
    }
}

impl LieAlgebra for Su2 {
    type Element<T: Real> = Vector3<T>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        So3.bracket(xi, eta)
    }

    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &Vector3<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        So3.coadjoint(xi, mu)
    }
}

/// The group SU(2) of unitary 2×2 matrices of determinant 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SU2;

impl SU2 {
    /// Applies the double cover SU(2) → SO(3), U ↦ R with U (v·e) U∗ = (Rv)·e.
    ///
    /// ```
    /// use lie_poisson::{LieGroup, SO3, SU2};
    /// use nalgebra::Vector3;
    /// let xi = Vector3::new(0.3, -1.1, 0.4);
    /// let difference = SU2.rotation(&SU2.exp(&xi)) - SO3.exp(&xi);
    /// assert!(difference.amax() < 1e-15);
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub fn rotation<T: Real>(&self, u: &Matrix2<Complex<T>>) -> Matrix3<T> {
        let column = |v: Vector3<T>| Su2.coordinates(&(u * Su2.matrix(&v) * self.inverse(u)));
        Matrix3::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z()].map(column))
    }
}

impl LieGroup for SU2 {
    type Algebra = Su2;
    type Element<T: Real> = Matrix2<Complex<T>>;

    fn algebra(&self) -> Su2 {
        Su2
    }

    #[cfg_attr(optimised, inline(always))]
    fn identity<T: Real>(&self) -> Matrix2<Complex<T>> {
        Matrix2::identity()
    }

    #[cfg_attr(optimised, inline(always))]
    fn compose<T: Real>(
        &self,
        g: &Matrix2<Complex<T>>,
        h: &Matrix2<Complex<T>>,
    ) -> Matrix2<Complex<T>> {
        g * h
    }

    /// Returns the inverse U∗ of a unitary matrix.
    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, g: &Matrix2<Complex<T>>) -> Matrix2<Complex<T>> {
        g.map(|z| z.conj()).transpose()
    }

    /// Returns exp ξ = c₀(|ξ|²/4) I + c₁(|ξ|²/4) ξ, since ξ² = −(|ξ|²/4) I.
    ///
    /// c₀ and c₁ are [Stumpff functions](Real::stumpff). Angles are in radians, and exp is periodic in |ξ|
    /// with period 4π along each axis.
    #[cfg_attr(optimised, inline(always))]
    fn exp<T: Real>(&self, xi: &Vector3<T>) -> Matrix2<Complex<T>> {
        let x = xi.dot(xi) * 0.25;
        let cosine = Complex { re: x.stumpff(0), im: T::zero() };
        Matrix2::from_diagonal_element(cosine) + Su2.matrix(&(xi * x.stumpff(1)))
    }

    /// Returns the coordinates of `Ad_U ξ = U ξ U∗`.
    #[cfg_attr(optimised, inline(always))]
    fn adjoint<T: Real>(&self, g: &Matrix2<Complex<T>>, xi: &Vector3<T>) -> Vector3<T> {
        Su2.coordinates(&(g * Su2.matrix(xi) * self.inverse(g)))
    }

    /// Returns the coordinates of `Ad∗_U μ = U∗ μ U`.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        g: &Matrix2<Complex<T>>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        SO3.coadjoint(&self.rotation(g), mu)
    }
}
