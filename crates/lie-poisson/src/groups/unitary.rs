//! The Lie algebra u(N) and the group U(N).

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::LieGroup;
use generic_scalars::{Covector, Real, State, Vector, vector_operators};
use nalgebra::SMatrix;
use num_complex::Complex;

/// A skew-Hermitian matrix ξ∗ = −ξ, an element of the Lie algebra u(N).
///
/// Its N² real coordinates are stored in the places of an N×N matrix, by columns: `−i ξ_jj` on the diagonal, and for
/// j > k `Re ξ_jk` below it and `Im ξ_jk = Im ξ_kj` above it. A momentum μ ∈ u(N)∗ is a covector of these.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct SkewHermitian<T, const N: usize>(SMatrix<Complex<T>, N, N>);

impl<T: Real, const N: usize> SkewHermitian<T, N> {
    /// Returns the skew-Hermitian part ½(A − A∗) of a matrix.
    #[inline]
    pub fn part_of(a: &SMatrix<Complex<T>, N, N>) -> Self {
        let half = |z: Complex<T>| Complex { re: z.re * 0.5, im: z.im * 0.5 };
        Self((a - adjoint(a)).map(half))
    }

    /// Returns the skew-Hermitian matrix as a plain matrix.
    #[inline]
    pub fn matrix(&self) -> &SMatrix<Complex<T>, N, N> {
        &self.0
    }
}

/// Returns the conjugate transpose A∗.
fn adjoint<T: Real, const N: usize>(a: &SMatrix<Complex<T>, N, N>) -> SMatrix<Complex<T>, N, N> {
    a.transpose().map(|z| z.conj())
}

impl<T: Real, const N: usize> State for SkewHermitian<T, N> {
    type Scalar = T;
    type Blocks = (T,);
    type Shape = ();
    type Pool = ();

    #[inline]
    fn dimension(&self) -> usize {
        Self::DIM
    }

    #[inline]
    fn shape(&self) {}

    #[inline]
    fn zeros_of((): &()) -> Self {
        Self::zero()
    }

    #[inline]
    fn coordinate(&self, i: usize) -> T {
        let (j, k) = (i % N.max(1), i / N.max(1));
        self.0.get((j, k)).map_or_else(T::zero, |z| if j > k { z.re } else { z.im })
    }

    #[inline]
    fn set_coordinate(&mut self, i: usize, x: T) {
        *self = Self::from_coordinates(|j| if i == j { x } else { self.coordinate(j) });
    }

    #[inline]
    fn set_coordinates(&mut self, f: impl Fn(usize) -> T) {
        *self = Self::from_coordinates(f);
    }

    #[inline]
    fn add_in_place(&mut self, x: &Self) {
        self.0 += x.0;
    }

    #[inline]
    fn subtract_in_place(&mut self, x: &Self) {
        self.0 -= x.0;
    }

    #[inline]
    fn negate_in_place(&mut self) {
        self.0 = -self.0;
    }

    #[inline]
    fn scale_in_place(&mut self, s: T) {
        self.0.scale_in_place(s);
    }

    #[inline]
    fn add_multiple(&mut self, s: T, x: &Self) {
        self.0.add_multiple(s, &x.0);
    }
}

vector_operators!([T: Real, const N: usize] SkewHermitian<T, N>);

impl<T: Real, const N: usize> Vector for SkewHermitian<T, N> {
    type Dual = Covector<Self>;
    const DIM: usize = N * N;

    #[inline]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let x = SMatrix::<T, N, N>::from_fn(|j, k| f(j + N * k));
        Self(SMatrix::from_fn(|j, k| match j.cmp(&k) {
            core::cmp::Ordering::Equal => Complex { re: T::zero(), im: x[(j, j)] },
            core::cmp::Ordering::Greater => Complex { re: x[(j, k)], im: x[(k, j)] },
            core::cmp::Ordering::Less => Complex { re: -x[(k, j)], im: x[(j, k)] },
        }))
    }
}

/// The Lie algebra u(N) of skew-Hermitian matrices with the commutator.
///
/// ```
/// use lie_poisson::{LieAlgebra, SkewHermitian, UnitaryAlgebra, Vector};
/// let xi = SkewHermitian::<f64, 3>::from_coordinates(|i| i as f64);
/// let eta = SkewHermitian::from_coordinates(|i| (i * i) as f64 - 4.0);
/// let bracket = UnitaryAlgebra.bracket(&xi, &eta);
/// assert_eq!(*bracket.matrix(), xi.matrix() * eta.matrix() - eta.matrix() * xi.matrix());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnitaryAlgebra<const N: usize>;

impl<const N: usize> LieAlgebra for UnitaryAlgebra<N> {
    type Element<T: Real> = SkewHermitian<T, N>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(
        &self,
        xi: &SkewHermitian<T, N>,
        eta: &SkewHermitian<T, N>,
    ) -> SkewHermitian<T, N> {
        SkewHermitian(xi.0 * eta.0 - eta.0 * xi.0)
    }

    /// Returns the momentum of the matrix Hξ − ξH, for the Hermitian matrix H of μ.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &SkewHermitian<T, N>,
        mu: &Covector<SkewHermitian<T, N>>,
    ) -> Covector<SkewHermitian<T, N>> {
        let h = self.hermitian(mu);
        self.momentum(&(h * xi.0 - xi.0 * h))
    }
}

impl<const N: usize> UnitaryAlgebra<N> {
    /// Returns the Hermitian matrix H of a momentum, with ⟨μ, ξ⟩ = Re tr((iH)∗ ξ) = Im tr(Hξ).
    ///
    /// In terms of H, `ad∗_ξ μ` is Hξ − ξH and `Ad∗_U μ` is U∗HU.
    #[cfg_attr(optimised, inline(always))]
    pub fn hermitian<T: Real>(
        &self,
        mu: &Covector<SkewHermitian<T, N>>,
    ) -> SMatrix<Complex<T>, N, N> {
        let m = mu.0.matrix();
        SMatrix::from_fn(|j, k| {
            let share = if j == k { 1.0 } else { 0.5 };
            Complex { re: m[(j, k)].im * share, im: -m[(j, k)].re * share }
        })
    }

    /// Returns the momentum of a Hermitian matrix, the inverse of [`hermitian`](Self::hermitian).
    ///
    /// For any other matrix it is the momentum of its Hermitian part.
    #[cfg_attr(optimised, inline(always))]
    pub fn momentum<T: Real>(
        &self,
        h: &SMatrix<Complex<T>, N, N>,
    ) -> Covector<SkewHermitian<T, N>> {
        let m = SMatrix::from_fn(|j, k| {
            let share = if j == k { 1.0 } else { 2.0 };
            Complex { re: -h[(j, k)].im * share, im: h[(j, k)].re * share }
        });
        Covector(SkewHermitian::part_of(&m))
    }
}

/// The group U(N) of unitary matrices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnitaryGroup<const N: usize>;

impl<const N: usize> LieGroup for UnitaryGroup<N> {
    type Algebra = UnitaryAlgebra<N>;
    type Element<T: Real> = SMatrix<Complex<T>, N, N>;

    fn algebra(&self) -> UnitaryAlgebra<N> {
        UnitaryAlgebra
    }

    #[cfg_attr(optimised, inline(always))]
    fn identity<T: Real>(&self) -> SMatrix<Complex<T>, N, N> {
        SMatrix::identity()
    }

    #[cfg_attr(optimised, inline(always))]
    fn compose<T: Real>(
        &self,
        g: &SMatrix<Complex<T>, N, N>,
        h: &SMatrix<Complex<T>, N, N>,
    ) -> SMatrix<Complex<T>, N, N> {
        g * h
    }

    /// Returns the inverse U∗ of a unitary matrix.
    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, g: &SMatrix<Complex<T>, N, N>) -> SMatrix<Complex<T>, N, N> {
        adjoint(g)
    }

    /// Returns the matrix exponential, by its series for ξ/2ᵐ with |ξ/2ᵐ| ≤ ¼, squared m times.
    fn exp<T: Real>(&self, xi: &SkewHermitian<T, N>) -> SMatrix<Complex<T>, N, N> {
        let size = xi.max_abs() * N as f64;
        let halvings = if size > 0.25 { (size * 4.0).log2().ceil().min(1000.0) } else { 0.0 };
        let small = xi.0.scaled(T::from_f64((-halvings).exp2()));
        // 14 terms suffice: 0.25¹⁵/15! < 2⁻⁶⁰.
        let series = (1..=14).rev().fold(SMatrix::identity(), |tail, k| {
            SMatrix::identity() + (small * tail).scaled(T::from_f64(1.0 / f64::from(k)))
        });
        (0..halvings as usize).fold(series, |g, _| g * g)
    }

    /// Returns the conjugate `Ad_U ξ = U ξ U∗`.
    #[cfg_attr(optimised, inline(always))]
    fn adjoint<T: Real>(
        &self,
        g: &SMatrix<Complex<T>, N, N>,
        xi: &SkewHermitian<T, N>,
    ) -> SkewHermitian<T, N> {
        SkewHermitian::part_of(&(g * xi.0 * adjoint(g)))
    }

    /// Returns `Ad∗_U μ`, the momentum of the matrix U∗HU, for the Hermitian matrix H of μ.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        g: &SMatrix<Complex<T>, N, N>,
        mu: &Covector<SkewHermitian<T, N>>,
    ) -> Covector<SkewHermitian<T, N>> {
        UnitaryAlgebra.momentum(&(adjoint(g) * UnitaryAlgebra.hermitian(mu) * g))
    }
}
