//! The Laplace operator of the sphere on N×N matrices: [`QuantisedLaplacian`].

use crate::error::SystemError;
use isospectral_flows::LargeSkewHermitian;
use lie_poisson::Real;

/// The Laplace operator of the unit sphere on N×N matrices, with spin matrices S_a of spin s = (N − 1)/2:
///
/// ```text
/// Δ W = −Σ_a [S_a, [S_a, W]]
/// ```
///
/// Its eigenvalues are −l(l + 1) with l = 0 … N − 1, each 2l + 1 times, like the eigenvalues of the Laplace operator on
/// functions of degree below N. It couples only neighbours on a diagonal of W:
///
/// ```text
/// −(ΔW)_jk = d_jk W_jk − b_jk W_(j−1,k−1) − b_(j+1,k+1) W_(j+1,k+1)
/// b_jk = α_j α_k,    α_j² = j(N − j),    d_jk = b_jk + b_(j+1,k+1) + σ_jk
/// σ_jk = (j − k)² + (α_j − α_k)²/2 + (α_(j+1) − α_(k+1))²/2
/// ```
///
/// with j, k = 0 … N − 1. The inverse solves these tridiagonal equations, all diagonals at once, in O(N²) time and
/// memory. Its factors are computed from σ without subtractions, so that each of them is accurate to a few roundings.
///
/// Source: Hoppe & Yau, *Some properties of matrix harmonics on S²*, Comm. Math. Phys. 195 (1998); Cifani, Viviani &
/// Modin, *An efficient geometric method for incompressible hydrodynamics on the sphere*, J. Comput. Phys. 473 (2023).
///
/// # Example
/// ```
/// use lie_poisson_systems::QuantisedLaplacian;
/// use lie_poisson_systems::isospectral_flows::LargeSkewHermitian;
/// use lie_poisson_systems::num_complex::Complex;
/// let size = 8;
/// let laplacian = QuantisedLaplacian::new(size)?;
/// let w = LargeSkewHermitian::from_upper(size, |j, k| Complex::new((j * k) as f64, if j == k { j as f64 - 3.5 } else { 1.0 }));
/// let (mut p, mut back) = (w.clone(), w.clone());
/// laplacian.solve(1.0, &w, &mut p);
/// laplacian.apply(&p, &mut back);
/// let largest = |f: &dyn Fn(usize) -> f64| (0..size * size).map(f).fold(0.0, lie_poisson::larger);
/// let error = largest(&|i| (back.at(i % size, i / size) - w.at(i % size, i / size)).norm());
/// assert!(error < 1e-12);
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct QuantisedLaplacian {
    size: usize,
    /// The numbers α_j, j = 0 … N.
    alpha: Vec<f64>,
    /// The reciprocals of the pivots of −Δ, column by column. That of the last entry of the main diagonal is 0.
    inverse_pivots: Vec<f64>,
    /// The factors b_jk/pivot_(j−1,k−1), column by column.
    factors: Vec<f64>,
}

impl QuantisedLaplacian {
    /// Creates the operator on N×N matrices, for N ≥ 2.
    ///
    /// # Errors
    /// Returns [`SystemError::Count`] if N is below 2, or [`SystemError::TooMany`] if N² exceeds the range of `usize`.
    pub fn new(size: usize) -> Result<Self, SystemError> {
        if size < 2 {
            return Err(SystemError::Count { name: "rows of a matrix", expected: 2, found: size });
        }
        if size.checked_mul(size).is_none() {
            return Err(SystemError::TooMany { name: "entries of a matrix" });
        }
        let alpha = (0..=size).map(|j| ((j * (size - j)) as f64).sqrt()).collect();
        let zeros = vec![0.0; size * size];
        let mut laplacian = Self { size, alpha, inverse_pivots: zeros.clone(), factors: zeros };
        for k in 0..size {
            laplacian.factor_diagonal(k);
        }
        Ok(laplacian)
    }

    /// Returns the size N.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// Returns b_jk = α_j α_k.
    pub(crate) fn coupling(&self, j: usize, k: usize) -> f64 {
        self.alpha[j] * self.alpha[k]
    }

    /// Returns σ_jk, without a subtraction of numbers that are not integers.
    fn surplus(&self, j: usize, k: usize) -> f64 {
        let difference = |j: usize, k: usize| {
            let sum = self.alpha[j] + self.alpha[k];
            let [j, k, n] = [j, k, self.size].map(|x| x as f64);
            if sum > 0.0 { (j - k) * (n - j - k) / sum } else { 0.0 }
        };
        let (here, next) = (difference(j, k), difference(j + 1, k + 1));
        (j as f64 - k as f64).powi(2) + 0.5 * (here * here + next * next)
    }

    /// Returns the diagonal entry d_jk of −Δ.
    pub(crate) fn diagonal(&self, j: usize, k: usize) -> f64 {
        self.coupling(j, k) + self.coupling(j + 1, k + 1) + self.surplus(j, k)
    }

    /// Computes the factors on the m-th diagonal above the main one and, by symmetry, below it.
    ///
    /// With the excess e of a pivot over the coupling to the next entry, e_j = σ_j + b_j e_(j−1)/pivot_(j−1).
    fn factor_diagonal(&mut self, m: usize) {
        let (n, mut excess, mut inverse) = (self.size, 0.0, 0.0);
        for j in 0..n - m {
            let k = j + m;
            let factor = self.coupling(j, k) * inverse;
            excess = self.surplus(j, k) + factor * excess;
            let pivot = self.coupling(j + 1, k + 1) + excess;
            inverse = if pivot > 0.0 { 1.0 / pivot } else { 0.0 };
            for i in [j + n * k, k + n * j] {
                (self.factors[i], self.inverse_pivots[i]) = (factor, inverse);
            }
        }
    }

    /// Writes the Laplacian ΔW. The result is NaN if a matrix does not have the size N.
    pub fn apply(&self, w: &LargeSkewHermitian, image: &mut LargeSkewHermitian) {
        let n = self.size;
        if [w.size(), image.size()] != [n; 2] {
            return spoil(image);
        }
        let of = |x: &[f64], image: &mut [f64]| {
            for (k, j) in (0..n).flat_map(|k| (0..=k).map(move |j| (k, j))) {
                let mut sum = -self.diagonal(j, k) * x[j + n * k];
                if j > 0 {
                    sum += self.coupling(j, k) * x[j - 1 + n * (k - 1)];
                }
                if k + 1 < n {
                    sum += self.coupling(j + 1, k + 1) * x[j + 1 + n * (k + 1)];
                }
                image[j + n * k] = sum;
            }
        };
        image.change_upper(|re, im| {
            of(w.matrix().real(), re);
            of(w.matrix().imaginary(), im);
        });
    }

    /// Writes the trace-free matrix P that solves ΔP = s W.
    ///
    /// The trace of W, on which the operator is zero, is ignored. The result is NaN if a matrix does not have the size
    /// N.
    pub fn solve(&self, s: f64, w: &LargeSkewHermitian, p: &mut LargeSkewHermitian) {
        let n = self.size;
        if [w.size(), p.size()] != [n; 2] {
            return spoil(p);
        }
        let mean = w.trace() / n as f64;
        p.change_upper(|re, im| {
            self.solve_upper(-s, w.matrix().real(), 0.0, re);
            self.solve_upper(-s, w.matrix().imaginary(), mean, im);
            let mean = (0..n).map(|j| im[j + n * j]).sum::<f64>() / n as f64;
            (0..n).for_each(|j| im[j + n * j] -= mean);
        });
    }

    /// Solves −ΔX = s Y for real X on and above the diagonal, one column after the other. The mean is subtracted from
    /// the diagonal of Y.
    pub(crate) fn solve_upper<T: Real>(&self, s: f64, y: &[T], mean: T, x: &mut [T]) {
        let n = self.size;
        x[0] = (y[0] - mean) * s;
        for k in 1..n {
            let (before, column) = x.split_at_mut(n * k);
            let (above, factors) = (&before[n * (k - 1)..], &self.factors[n * k..]);
            let y = &y[n * k..];
            column[0] = y[0] * s;
            for (((x, y), above), factor) in
                column[1..k].iter_mut().zip(&y[1..k]).zip(above).zip(&factors[1..k])
            {
                *x = *y * s + *above * *factor;
            }
            column[k] = (y[k] - mean) * s + above[k - 1] * factors[k];
        }
        for k in (0..n).rev() {
            let (columns, after) = x.split_at_mut(n * (k + 1));
            let (column, inverse) = (&mut columns[n * k..], &self.inverse_pivots[n * k..]);
            if k + 1 == n {
                column.iter_mut().zip(inverse).for_each(|(x, inverse)| *x = *x * *inverse);
                continue;
            }
            let (below, factors) = (&after[1..], &self.factors[n * (k + 1) + 1..]);
            for (((x, inverse), below), factor) in
                column[..=k].iter_mut().zip(inverse).zip(&below[..=k]).zip(&factors[..=k])
            {
                *x = *x * *inverse + *below * *factor;
            }
        }
    }
}

/// Makes a matrix NaN.
fn spoil(matrix: &mut LargeSkewHermitian) {
    matrix.change_upper(|re, im| {
        re.fill(f64::NAN);
        im.fill(f64::NAN);
    });
}
