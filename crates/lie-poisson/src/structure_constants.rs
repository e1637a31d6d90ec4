//! Lie algebras given by structure constants.

use crate::{LieAlgebra, Real, larger};
use nalgebra::SVector;
use std::sync::Arc;
use thiserror::Error;

/// A table of numbers that is not the bracket of a Lie algebra.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum StructureError {
    /// A constant is infinite or not a number.
    #[error("the structure constant c[{i}][{j}][{k}] = {value} is not finite")]
    NotFinite {
        /// First index of the bracket.
        i: usize,
        /// Second index of the bracket.
        j: usize,
        /// The coordinate.
        k: usize,
        /// The constant.
        value: f64,
    },
    /// [e_i, e_j] ≠ −[e_j, e_i].
    #[error(
        "not antisymmetric: [e{i}, e{j}] + [e{j}, e{i}] has the coordinate {residual:e} at {k}"
    )]
    NotAntisymmetric {
        /// First index of the bracket.
        i: usize,
        /// Second index of the bracket.
        j: usize,
        /// The coordinate.
        k: usize,
        /// The sum that should be zero.
        residual: f64,
    },
    /// The cyclic sum of [e_i, [e_j, e_k]] is not zero, once the constants are divided by the
    /// largest of them.
    #[error("the Jacobi identity fails by {residual:e} for e{i}, e{j}, e{k} (allowed {allowed:e})")]
    Jacobi {
        /// First basis vector.
        i: usize,
        /// Second basis vector.
        j: usize,
        /// Third basis vector.
        k: usize,
        /// The largest coordinate of the cyclic sum.
        residual: f64,
        /// The rounding that is allowed for.
        allowed: f64,
    },
}

/// The Lie algebra with `[e_i, e_j] = Σ_k c[i][j][k] e_k`, of dimension N.
///
/// # Example
/// ```
/// use lie_poisson::{LieAlgebra, StructureConstants};
/// use nalgebra::Vector3;
/// // so(3): c[i][j][k] = ε_ijk
/// let epsilon = |i: usize, j: usize, k: usize| {
///     ((j as f64 - i as f64) * (k as f64 - j as f64) * (k as f64 - i as f64)) / 2.0
/// };
/// let so3 = StructureConstants::<3>::new(epsilon)?;
/// let (xi, eta) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
/// assert_eq!(so3.bracket(&xi, &eta), xi.cross(&eta));
/// // a sign changed in one place, and it is no Lie algebra
/// let broken = |i, j, k| if (i, j, k) == (0, 1, 2) { -1.0 } else { epsilon(i, j, k) };
/// assert!(StructureConstants::<3>::new(broken).is_err());
/// # Ok::<(), lie_poisson::StructureError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StructureConstants<const N: usize> {
    /// `c[i][j][k]` at (i N + j) N + k.
    constants: Arc<[f64]>,
}

impl<const N: usize> StructureConstants<N> {
    /// From `c(i, j, k) = c[i][j][k]`, the k-th coordinate of `[e_i, e_j]`.
    ///
    /// # Errors
    /// If a constant is not finite, the bracket is not antisymmetric (exactly), or the Jacobi
    /// identity fails by more than the rounding of the sums in it.
    pub fn new(c: impl Fn(usize, usize, usize) -> f64) -> Result<Self, StructureError> {
        let constants: Arc<[f64]> = indices::<N>().map(|(i, j, k)| c(i, j, k)).collect();
        let at = |i: usize, j: usize, k: usize| entry::<N>(&constants, i, j, k);
        for (i, j, k) in indices::<N>() {
            let value = at(i, j, k);
            if !value.is_finite() {
                return Err(StructureError::NotFinite { i, j, k, value });
            }
        }
        for (i, j, k) in indices::<N>() {
            let residual = at(i, j, k) + at(j, i, k);
            if residual != 0.0 {
                return Err(StructureError::NotAntisymmetric { i, j, k, residual });
            }
        }
        check_jacobi::<N>(&constants)?;
        Ok(Self { constants })
    }

    /// `c[i][j][k]`; zero beyond the dimension.
    #[must_use]
    pub fn constant(&self, i: usize, j: usize, k: usize) -> f64 {
        if i.max(j).max(k) < N { entry::<N>(&self.constants, i, j, k) } else { 0.0 }
    }
}

fn indices<const N: usize>() -> impl Iterator<Item = (usize, usize, usize)> {
    (0..N * N * N).map(|n| (n / (N * N), n / N % N, n % N))
}

/// `c[i][j][k]` for indices below N.
#[inline]
fn entry<const N: usize>(constants: &[f64], i: usize, j: usize, k: usize) -> f64 {
    constants[(i * N + j) * N + k]
}

fn check_jacobi<const N: usize>(constants: &[f64]) -> Result<(), StructureError> {
    let largest = constants.iter().fold(0.0, |m, x| larger(m, x.abs()));
    // Normalised, so that no product overflows and none that matters underflows.
    let constants: Vec<f64> = constants.iter().map(|x| x / largest).collect();
    let c = |i: usize, j: usize, k: usize| entry::<N>(&constants, i, j, k);
    // 3N products of two constants, each rounded three times, and their sum.
    let allowed = 12.0 * N as f64 * f64::EPSILON;
    // The cyclic sum of an antisymmetric bracket is alternating.
    for (i, j, k) in indices::<N>().filter(|&(i, j, k)| largest > 0.0 && i < j && j < k) {
        let nested = |a: usize, b: usize, d: usize, m: usize| -> f64 {
            (0..N).map(|l| c(b, d, l) * c(a, l, m)).sum()
        };
        let residual = (0..N)
            .map(|m| (nested(i, j, k, m) + nested(j, k, i, m) + nested(k, i, j, m)).abs())
            .fold(0.0, larger);
        if residual.is_nan() || residual > allowed {
            return Err(StructureError::Jacobi { i, j, k, residual, allowed });
        }
    }
    Ok(())
}

impl<const N: usize> LieAlgebra for StructureConstants<N> {
    type Element<T: Real> = SVector<T, N>;

    fn bracket<T: Real>(&self, xi: &SVector<T, N>, eta: &SVector<T, N>) -> SVector<T, N> {
        let mut bracket = SVector::zeros();
        for i in 0..N {
            for j in 0..N {
                let weight = xi[i] * eta[j];
                for k in 0..N {
                    bracket[k] += weight * entry::<N>(&self.constants, i, j, k);
                }
            }
        }
        bracket
    }
}
