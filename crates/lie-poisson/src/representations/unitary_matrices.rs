//! The defining representations of the unitary groups.

use crate::groups::su2::{SU2, Su2};
use crate::groups::unitary::{SkewHermitian, UnitaryAlgebra, UnitaryGroup};
use crate::representations::representation::{GroupRepresentation, Representation};
use generic_scalars::{Covector, Real, Vector};
use nalgebra::{Matrix2, SMatrix, SVector, Vector2, Vector3};
use num_complex::Complex;

/// The representation of SU(2) on C² by matrix multiplication.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SU2OnC2;

impl Representation for SU2OnC2 {
    type Algebra = Su2;
    type Space<T: Real> = Vector2<Complex<T>>;

    fn algebra(&self) -> Su2 {
        Su2
    }

    /// Returns the product of the matrix −(i/2) ξ·σ and v, without multiplying by zeros.
    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
        let half = T::from_f64(0.5);
        let h = Vector3::new(xi.x * half, xi.y * half, xi.z * half);
        let (a, b) = (v.x, v.y);
        Vector2::new(
            Complex {
                re: h.z * a.im + (h.x * b.im - h.y * b.re),
                im: -(h.z * a.re) - (h.y * b.im + h.x * b.re),
            },
            Complex {
                re: h.y * a.re + h.x * a.im - h.z * b.im,
                im: h.y * a.im - h.x * a.re + h.z * b.re,
            },
        )
    }

    /// Returns ξᵀ α, which is ξ∗ α = −ξ α in coordinates.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &Vector3<T>,
        alpha: &Covector<Vector2<Complex<T>>>,
    ) -> Covector<Vector2<Complex<T>>> {
        -Covector(self.act(xi, &alpha.0))
    }

    /// Returns the diamond product `v ◇ α` = ½ Im (α∗σ₁v, α∗σ₂v, α∗σ₃v), with the Pauli matrices σ.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &Vector2<Complex<T>>,
        alpha: &Covector<Vector2<Complex<T>>>,
    ) -> Covector<Vector3<T>> {
        let (a, b, half) = (alpha.0.x, alpha.0.y, T::from_f64(0.5));
        let above = [a.re * v.y.re + a.im * v.y.im, a.re * v.y.im - a.im * v.y.re];
        let below = [b.re * v.x.re + b.im * v.x.im, b.re * v.x.im - b.im * v.x.re];
        let turn = (a.re * v.x.im - a.im * v.x.re) - (b.re * v.y.im - b.im * v.y.re);
        Covector(Vector3::new(
            (above[1] + below[1]) * half,
            (below[0] - above[0]) * half,
            turn * half,
        ))
    }
}

impl GroupRepresentation for SU2OnC2 {
    type Group = SU2;

    fn group(&self) -> SU2 {
        SU2
    }

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(
        &self,
        g: &Matrix2<Complex<T>>,
        v: &Vector2<Complex<T>>,
    ) -> Vector2<Complex<T>> {
        g * v
    }

    /// Returns c₁(y) φ + c₂(y) ξφ with y = |ξ|²/4, since ξ² = −y I.
    #[cfg_attr(optimised, inline(always))]
    fn exp_integral<T: Real>(
        &self,
        xi: &Vector3<T>,
        phi: &Vector2<Complex<T>>,
    ) -> Vector2<Complex<T>> {
        let y = xi.dot(xi) * 0.25;
        phi.scaled(y.stumpff(1)) + self.act(xi, phi).scaled(y.stumpff(2))
    }
}

/// The representation of U(N) on C^N by matrix multiplication.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnitaryOnComplexSpace<const N: usize>;

impl<const N: usize> Representation for UnitaryOnComplexSpace<N> {
    type Algebra = UnitaryAlgebra<N>;
    type Space<T: Real> = SVector<Complex<T>, N>;

    fn algebra(&self) -> UnitaryAlgebra<N> {
        UnitaryAlgebra
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(
        &self,
        xi: &SkewHermitian<T, N>,
        v: &SVector<Complex<T>, N>,
    ) -> SVector<Complex<T>, N> {
        xi.matrix() * v
    }

    /// Returns ξᵀ α, which is ξ∗ α = −ξ α in coordinates.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &SkewHermitian<T, N>,
        alpha: &Covector<SVector<Complex<T>, N>>,
    ) -> Covector<SVector<Complex<T>, N>> {
        Covector(-(xi.matrix() * alpha.0))
    }

    /// Returns the diamond product `v ◇ α`, the momentum of the matrix −i α v∗, since ⟨α, ηv⟩ = Re tr((αv∗)∗ η).
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &SVector<Complex<T>, N>,
        alpha: &Covector<SVector<Complex<T>, N>>,
    ) -> Covector<SkewHermitian<T, N>> {
        let turned = alpha.0.map(|a| Complex { re: a.im, im: -a.re });
        UnitaryAlgebra.momentum(&(turned * v.map(|z| z.conj()).transpose()))
    }
}

impl<const N: usize> GroupRepresentation for UnitaryOnComplexSpace<N> {
    type Group = UnitaryGroup<N>;

    fn group(&self) -> UnitaryGroup<N> {
        UnitaryGroup
    }

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(
        &self,
        g: &SMatrix<Complex<T>, N, N>,
        v: &SVector<Complex<T>, N>,
    ) -> SVector<Complex<T>, N> {
        g * v
    }
}
