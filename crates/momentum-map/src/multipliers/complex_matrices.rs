//! Complex matrices as multipliers: [`ComplexMatrices`].

use crate::multipliers::multiplier::Multipliers;
use lie_poisson::{Covector, LiePoisson, Real, SkewHermitian, UnitaryAlgebra};
use nalgebra::SMatrix;
use num_complex::Complex;

/// Complex N×N matrices as multipliers, for u(N)∗ with the minus bracket.
///
/// In terms of the Hermitian matrix H of a momentum,
///
/// ```text
/// dQ/dt = −ξ Q,    H = Q H₀ Q*
/// ```
///
/// where H₀ may have any rank. Gauss methods for Q are isospectral integrators for H.
///
/// Source: K. Modin & M. Viviani, *Lie–Poisson methods for isospectral flows*, Found. Comput. Math.
/// 20 (2020).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ComplexMatrices<const N: usize>;

impl<const N: usize> Multipliers for ComplexMatrices<N> {
    type Space = LiePoisson<UnitaryAlgebra<N>>;
    type Multiplier<T: Real> = SMatrix<Complex<T>, N, N>;

    fn space(&self) -> Self::Space {
        LiePoisson::minus(UnitaryAlgebra)
    }

    #[cfg_attr(optimised, inline(always))]
    fn one<T: Real>(&self) -> SMatrix<Complex<T>, N, N> {
        SMatrix::identity()
    }

    #[cfg_attr(optimised, inline(always))]
    fn generate<T: Real>(
        &self,
        xi: &SkewHermitian<T, N>,
        q: &SMatrix<Complex<T>, N, N>,
    ) -> SMatrix<Complex<T>, N, N> {
        -(xi.matrix() * q)
    }

    #[cfg_attr(optimised, inline(always))]
    fn transport<T: Real>(
        &self,
        q: &SMatrix<Complex<T>, N, N>,
        mu: &Covector<SkewHermitian<T, N>>,
    ) -> Covector<SkewHermitian<T, N>> {
        let moved = q * UnitaryAlgebra.hermitian(mu) * q.transpose().map(|z| z.conj());
        UnitaryAlgebra.momentum(&moved)
    }

    #[cfg_attr(optimised, inline(always))]
    fn product<T: Real>(
        &self,
        q: &SMatrix<Complex<T>, N, N>,
        b: &SMatrix<Complex<T>, N, N>,
    ) -> SMatrix<Complex<T>, N, N> {
        q * b
    }

    /// Returns B∗(2 − BB∗), which is B∗ for unitary B and otherwise the inverse to second order in 1 − BB∗.
    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, b: &SMatrix<Complex<T>, N, N>) -> SMatrix<Complex<T>, N, N> {
        let adjoint = b.transpose().map(|z| z.conj());
        adjoint + adjoint * (SMatrix::identity() - b * adjoint)
    }
}
