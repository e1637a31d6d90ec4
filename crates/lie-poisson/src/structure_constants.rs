//! Lie algebras given by structure constants.

use crate::{LieAlgebra, Real};
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
    /// The cyclic sum of [e_i, [e_j, e_k]] is not zero.
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
    constants: Arc<[[[f64; N]; N]; N]>,
}

impl<const N: usize> StructureConstants<N> {
    /// From `c(i, j, k) = c[i][j][k]`, the k-th coordinate of `[e_i, e_j]`.
    ///
    /// # Errors
    /// If a constant is not finite, the bracket is not antisymmetric (exactly), or the Jacobi
    /// identity fails by more than the rounding of the sums in it.
    pub fn new(c: impl Fn(usize, usize, usize) -> f64) -> Result<Self, StructureError> {
        let mut constants = [[[0.0; N]; N]; N];
        for (i, j, k) in indices::<N>() {
            let value = c(i, j, k);
            if !value.is_finite() {
                return Err(StructureError::NotFinite { i, j, k, value });
            }
            constants[i][j][k] = value;
        }
        for (i, j, k) in indices::<N>() {
            let residual = constants[i][j][k] + constants[j][i][k];
            if residual != 0.0 {
                return Err(StructureError::NotAntisymmetric { i, j, k, residual });
            }
        }
        check_jacobi(&constants)?;
        Ok(Self { constants: Arc::new(constants) })
    }

    /// `c[i][j][k]`; zero beyond the dimension.
    #[must_use]
    pub fn constant(&self, i: usize, j: usize, k: usize) -> f64 {
        let row = self.constants.get(i).and_then(|rows| rows.get(j));
        row.and_then(|row| row.get(k)).copied().unwrap_or(0.0)
    }
}

fn indices<const N: usize>() -> impl Iterator<Item = (usize, usize, usize)> {
    (0..N * N * N).map(|n| (n / (N * N), n / N % N, n % N))
}

fn check_jacobi<const N: usize>(c: &[[[f64; N]; N]; N]) -> Result<(), StructureError> {
    let largest = c.iter().flatten().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    // 3N products of two constants, each rounded once, and their sum.
    let allowed = 6.0 * N as f64 * f64::EPSILON * largest * largest;
    for (i, j, k) in indices::<N>() {
        let nested = |a: usize, b: usize, d: usize, m: usize| -> f64 {
            (0..N).map(|l| c[b][d][l] * c[a][l][m]).sum()
        };
        let residual = (0..N)
            .map(|m| (nested(i, j, k, m) + nested(j, k, i, m) + nested(k, i, j, m)).abs())
            .fold(0.0, f64::max);
        if residual > allowed {
            return Err(StructureError::Jacobi { i, j, k, residual, allowed });
        }
    }
    Ok(())
}

impl<const N: usize> LieAlgebra for StructureConstants<N> {
    type Element<T: Real> = SVector<T, N>;

    fn bracket<T: Real>(&self, xi: &SVector<T, N>, eta: &SVector<T, N>) -> SVector<T, N> {
        SVector::from_fn(|k, _| {
            let mut sum = T::zero();
            for (i, j, _) in indices::<N>().filter(|&(_, _, l)| l == k) {
                sum += xi[i] * eta[j] * self.constants[i][j][k];
            }
            sum
        })
    }
}
