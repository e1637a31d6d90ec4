//! Symplectic vector spaces: [`SymplecticSpace`].

use lie_poisson::{Covector, Differential, Point, PoissonSpace, Real, Vector, VectorSpace};
use nalgebra::SVector;
use num_complex::Complex;

/// A symplectic vector space (P, Ω): a Poisson space whose tensor is constant and invertible.
///
/// ```text
/// i_X Ω = dH for X = X_H,    {F, H} = Ω(X_F, X_H)
/// ```
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §2.2; Ohsawa 2019,
/// eq. (4.3).
pub trait SymplecticSpace: PoissonSpace {
    /// Returns the symplectic form Ω(u, v).
    fn symplectic_form<T: Real>(&self, u: &Point<Self, T>, v: &Point<Self, T>) -> T;

    /// Returns the covector i_x Ω = Ω(x, ·), the inverse of
    /// [`hamiltonian_vector`](PoissonSpace::hamiltonian_vector).
    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &Point<Self, T>) -> Differential<Self, T> {
        Vector::from_coordinates(|i| self.symplectic_form::<T>(x, &Vector::basis(i)))
    }
}

/// The symplectic space C^N of z = q + ip, with Ω(u, v) = Im(u∗v) = dq ∧ dp and X_H = ∂H/∂p − i ∂H/∂q.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SymplecticComplexSpace<const N: usize>;

impl<const N: usize> VectorSpace for SymplecticComplexSpace<N> {
    type Point<T: Real> = SVector<Complex<T>, N>;
}

impl<const N: usize> PoissonSpace for SymplecticComplexSpace<N> {
    #[cfg_attr(optimised, inline(always))]
    fn hamiltonian_vector<T: Real>(
        &self,
        _: &SVector<Complex<T>, N>,
        dh: &Covector<SVector<Complex<T>, N>>,
    ) -> SVector<Complex<T>, N> {
        dh.0.map(|by| Complex { re: by.im, im: -by.re })
    }
}

impl<const N: usize> SymplecticSpace for SymplecticComplexSpace<N> {
    #[cfg_attr(optimised, inline(always))]
    fn symplectic_form<T: Real>(
        &self,
        u: &SVector<Complex<T>, N>,
        v: &SVector<Complex<T>, N>,
    ) -> T {
        let terms = u.iter().zip(v.iter());
        terms.fold(T::zero(), |sum, (u, v)| sum + u.re * v.im - u.im * v.re)
    }

    /// Returns the covector i_x Ω, which is ix in coordinates.
    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &SVector<Complex<T>, N>) -> Covector<SVector<Complex<T>, N>> {
        Covector(x.map(
            #[cfg_attr(optimised, inline(always))]
            |x| Complex { re: -x.im, im: x.re },
        ))
    }
}
