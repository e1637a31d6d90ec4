//! Cayley maps from an algebra to its group: [`Cayley`].

use crate::algebras::group::{AlgebraElement, LieGroup};
use crate::algebras::product::{PowerGroup, ProductGroup};
use crate::groups::sl2::{SL2, Sl2};
use crate::groups::so2::SO2;
use crate::groups::so3::{SO3, So3};
use crate::groups::su2::{SU2, Su2};
use crate::representations::euclidean::{SE2, SE3};
use crate::representations::sp1::SP1;
use generic_scalars::{Pair, Power, Quaternion, Real, RealSpace};
use nalgebra::{Matrix2, Matrix3, SVector, Vector1, Vector2, Vector3};
use num_complex::Complex;

/// Matrix groups with the Cayley map cay ξ = (I − ξ/2)⁻¹ (I + ξ/2).
///
/// It agrees with exp to second order, cay ξ = exp ξ + O(|ξ|³), and needs no transcendental function.
/// Translations x ↦ x + v are matrices too; for them cay and exp are equal.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed., §IV.8.3.
///
/// # Example
/// ```
/// use lie_poisson::{Cayley, SO3, So3};
/// use nalgebra::{Matrix3, Vector3};
/// let xi = Vector3::new(0.3, -1.1, 0.4);
/// let half = So3.hat(&xi) / 2.0;
/// let residual = (Matrix3::identity() - half) * SO3.cayley(&xi) - (Matrix3::identity() + half);
/// assert!(residual.norm() < 1e-15);
/// ```
pub trait Cayley: LieGroup {
    /// Returns the Cayley map cay ξ.
    fn cayley<T: Real>(&self, xi: &AlgebraElement<Self, T>) -> Self::Element<T>;
}

impl<const N: usize> Cayley for RealSpace<N> {
    /// Returns the translation by ξ.
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &SVector<T, N>) -> SVector<T, N> {
        *xi
    }
}

impl Cayley for SO2 {
    /// Returns the rotation by the angle 2 arctan(ω/2).
    fn cayley<T: Real>(&self, xi: &Vector1<T>) -> Matrix2<T> {
        let x = xi.x * xi.x * 0.25;
        let (cosine, sine) = (-x + 1.0, xi.x);
        Matrix2::new(cosine, -sine, sine, cosine) / (x + 1.0)
    }
}

impl Cayley for SO3 {
    /// Returns the rotation matrix I + (X + ½X²)/(1 + ¼|ξ|²), where X = hat(ξ).
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &Vector3<T>) -> Matrix3<T> {
        let (hat, x) = (So3.hat(xi), xi.dot(xi) * 0.25);
        Matrix3::identity() + (hat + hat * hat * T::from_f64(0.5)) / (x + 1.0)
    }
}

impl Cayley for SU2 {
    /// Returns the unitary matrix ((1 − |ξ|²/16) I + ξ)/(1 + |ξ|²/16).
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &Vector3<T>) -> Matrix2<Complex<T>> {
        let x = xi.dot(xi) * 0.0625;
        let (one, scale) = (-x + 1.0, T::one() / (x + 1.0));
        let matrix =
            Su2.matrix(xi) + Matrix2::from_diagonal_element(Complex { re: one, im: T::zero() });
        matrix.map(|z| z.scale(scale))
    }
}

impl Cayley for SP1 {
    /// Returns the unit quaternion (1 − |ξ|²/16 + ½ξ)/(1 + |ξ|²/16).
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &Vector3<T>) -> Quaternion<T> {
        let x = xi.dot(xi) * 0.0625;
        let size = x + 1.0;
        Quaternion { scalar: (-x + 1.0) / size, vector: xi * T::from_f64(0.5) / size }
    }
}

impl Cayley for SL2 {
    /// Returns the matrix ((1 − d/4) I + ξ)/(1 + d/4) with d = det ξ; not finite for d = −4, where I − ξ/2 is
    /// singular.
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &Vector3<T>) -> Matrix2<T> {
        let d = Sl2.determinant(xi) * 0.25;
        (Sl2.matrix(xi) + Matrix2::from_diagonal_element(-d + 1.0)) / (d + 1.0)
    }
}

impl Cayley for SE2 {
    /// Returns (cay ω, (I − ½ωJ)⁻¹ φ), with (I − ½ωJ)⁻¹ = ½(I + cay ω).
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &Pair<Vector1<T>, Vector2<T>>) -> Pair<Matrix2<T>, Vector2<T>> {
        let turn = SO2.cayley(&xi.0);
        Pair(turn, (turn * xi.1 + xi.1) * T::from_f64(0.5))
    }
}

impl Cayley for SE3 {
    /// Returns (cay ξ, (I − ½X)⁻¹ φ), where X = hat(ξ) and (I − ½X)⁻¹ = ½(I + cay ξ).
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &Pair<Vector3<T>, Vector3<T>>) -> Pair<Matrix3<T>, Vector3<T>> {
        let turn = SO3.cayley(&xi.0);
        Pair(turn, (turn * xi.1 + xi.1) * T::from_f64(0.5))
    }
}

impl<G: Cayley, H: Cayley> Cayley for ProductGroup<G, H> {
    /// Returns (cay ξ, cay η), factor by factor.
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &AlgebraElement<Self, T>) -> Self::Element<T> {
        Pair(self.0.cayley::<T>(&xi.0), self.1.cayley::<T>(&xi.1))
    }
}

impl<G: Cayley, const N: usize> Cayley for PowerGroup<G, N> {
    /// Returns (cay ξ₁, …, cay ξ_N), factor by factor.
    #[cfg_attr(optimised, inline(always))]
    fn cayley<T: Real>(&self, xi: &AlgebraElement<Self, T>) -> Self::Element<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.cayley::<T>(&xi.0[n]),
        )
    }
}
