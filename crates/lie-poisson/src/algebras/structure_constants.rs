//! Lie algebras from a table of structure constants: [`StructureConstants`].

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::structure_table::{StructureEntry, StructureError, StructureTable};
use generic_scalars::{Covector, Real};
use nalgebra::SVector;

/// The Lie algebra of dimension N with the bracket `[e_i, e_j] = Σ_k c[i][j][k] e_k`.
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
/// // a table with one sign changed is not a Lie algebra
/// let broken = |i, j, k| if (i, j, k) == (0, 1, 2) { -1.0 } else { epsilon(i, j, k) };
/// assert!(StructureConstants::<3>::new(broken).is_err());
/// # Ok::<(), lie_poisson::StructureError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StructureConstants<const N: usize>(StructureTable);

impl<const N: usize> StructureConstants<N> {
    /// Creates the algebra from `c(i, j, k) = c[i][j][k]`, the k-th coordinate of `[e_i, e_j]`.
    ///
    /// # Errors
    /// Returns the errors of [`StructureTable::new`].
    pub fn new(c: impl Fn(usize, usize, usize) -> f64) -> Result<Self, StructureError> {
        let indices = (0..N * N * N).map(|place| (place / (N * N), place / N % N, place % N));
        let constant = |(i, j, k)| StructureEntry { i, j, k, value: c(i, j, k) };
        StructureTable::new(N, indices.map(constant)).map(Self)
    }

    /// Returns the algebra of a table, or `None` if it has another dimension.
    #[must_use]
    pub fn of_table(table: StructureTable) -> Option<Self> {
        (table.dimension() == N).then_some(Self(table))
    }

    /// Returns the constant `c[i][j][k]`, or zero for indices beyond the dimension.
    #[must_use]
    pub fn constant(&self, i: usize, j: usize, k: usize) -> f64 {
        self.0.constant(i, j, k)
    }
}

impl<const N: usize> LieAlgebra for StructureConstants<N> {
    type Element<T: Real> = SVector<T, N>;

    fn bracket<T: Real>(&self, xi: &SVector<T, N>, eta: &SVector<T, N>) -> SVector<T, N> {
        let mut bracket = SVector::zeros();
        for &StructureEntry { i, j, k, value } in self.0.entries() {
            bracket[k] += xi[i] * eta[j] * value;
        }
        bracket
    }

    /// Returns ad∗_ξ μ, with the coordinates `Σ c[i][j][k] ξ_i μ_k`.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &SVector<T, N>,
        mu: &Covector<SVector<T, N>>,
    ) -> Covector<SVector<T, N>> {
        let mut rate = SVector::<T, N>::zeros();
        self.0.coadjoint(xi.as_slice(), mu.0.as_slice(), rate.as_mut_slice());
        Covector(rate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns ε_ijk for indices below 3, and 0 elsewhere.
    fn epsilon(i: usize, j: usize, k: usize) -> f64 {
        let difference = |a: usize, b: usize| a as f64 - b as f64;
        if i.max(j).max(k) < 3 {
            difference(j, i) * difference(k, j) * difference(k, i) / 2.0
        } else {
            0.0
        }
    }

    /// Returns a table that is antisymmetric but not a Lie algebra: [e₀, e₁] = e₂, [e₁, e₂] = e₂, [e₀, e₂]
    /// = e₁, for which the cyclic sum is e₁.
    fn broken(i: usize, j: usize, k: usize) -> f64 {
        match (i, j, k) {
            (0, 1, 2) | (1, 2, 2) | (0, 2, 1) => 1.0,
            (1, 0, 2) | (2, 1, 2) | (2, 0, 1) => -1.0,
            _ => 0.0,
        }
    }

    /// Returns the direct sum of two three-dimensional tables.
    fn sum(
        first: impl Fn(usize, usize, usize) -> f64,
        second: impl Fn(usize, usize, usize) -> f64,
    ) -> Result<StructureConstants<6>, StructureError> {
        StructureConstants::new(|i, j, k| match (i, j, k) {
            (0..3, 0..3, 0..3) => first(i, j, k),
            (3.., 3.., 3..) => second(i - 3, j - 3, k - 3),
            _ => 0.0,
        })
    }

    const SCALES: [f64; 9] = [5e-324, 1e-300, 1e-150, 1e-9, 1.0, 1e9, 1e150, 1e300, f64::MAX];

    #[test]
    fn direct_sums_of_any_scales_are_told_from_what_is_no_lie_algebra() {
        for large in SCALES {
            for small in SCALES {
                let scaled = |scale: f64| move |i, j, k| scale * epsilon(i, j, k);
                assert!(sum(scaled(large), scaled(small)).is_ok(), "{large:e} {small:e}");
                let no_algebra = sum(scaled(large), |i, j, k| small * broken(i, j, k));
                let fails = matches!(
                    no_algebra,
                    Err(StructureError::Jacobi { i: 3, j: 4, k: 5, residual, .. }) if residual > 0.05
                );
                assert!(fails, "{large:e} {small:e}: {no_algebra:?}");
            }
        }
    }

    /// [e₀, e₁] = e₂, [e₁, e₂] = s e₀, [e₂, e₀] = s e₁ is so(3) for s = 1 and Heisenberg's algebra in the
    /// limit s → 0. With [e₁, e₂] = s (e₀ + e₁) it is not a Lie algebra for any s.
    #[test]
    fn contractions_are_lie_algebras() {
        for s in SCALES {
            let contracted = |spoilt: f64| {
                StructureConstants::<3>::new(move |i, j, k| match (i, j, k) {
                    (0, 1, 2) => 1.0,
                    (1, 0, 2) => -1.0,
                    (1, 2, 0) | (2, 0, 1) => s,
                    (2, 1, 0) | (0, 2, 1) => -s,
                    (1, 2, 1) => spoilt,
                    (2, 1, 1) => -spoilt,
                    _ => 0.0,
                })
            };
            assert!(contracted(0.0).is_ok(), "{s:e}");
            assert!(contracted(s).is_err(), "{s:e}");
        }
    }

    /// Each basis vector has a unit of its own: c[i][j][k] λ_i λ_j/λ_k.
    #[test]
    fn units_of_the_basis_do_not_matter() {
        let units = [1e-40, 1e20, 1e50];
        let scaled = |c: fn(usize, usize, usize) -> f64| {
            StructureConstants::<3>::new(move |i, j, k| {
                c(i, j, k) * (units[i] * units[j]) / units[k]
            })
        };
        assert!(scaled(epsilon).is_ok());
        assert!(scaled(broken).is_err());
    }

    /// so(3) ⊕ so(3) in a basis with rounded coordinates: zeros become numbers of the size of a rounding
    /// error, which do not violate the Jacobi identity.
    #[test]
    fn the_rounding_of_a_change_of_basis_is_allowed_for() {
        type Basis = nalgebra::SMatrix<f64, 6, 6>;
        let basis = Basis::from_fn(|i, j| ((i * i + 1) as f64 * (j as f64 + 0.3)).sin());
        let inverse = basis.try_inverse().unwrap_or_else(Basis::zeros);
        let original = |i: usize, j: usize, k: usize| match (i, j, k) {
            (0..3, 0..3, 0..3) => epsilon(i, j, k),
            (3.., 3.., 3..) => 7.0 * epsilon(i - 3, j - 3, k - 3),
            _ => 0.0,
        };
        let changed = |error: f64| {
            StructureConstants::<6>::new(move |i, j, k| {
                let (sign, first, second) = if i < j { (1.0, i, j) } else { (-1.0, j, i) };
                if i == j {
                    return 0.0;
                }
                let sum: f64 = (0..216)
                    .map(|place| (place / 36, place / 6 % 6, place % 6))
                    .map(|(a, b, d)| {
                        basis[(a, first)] * basis[(b, second)] * original(a, b, d) * inverse[(k, d)]
                    })
                    .sum();
                let spoilt = if (first, second, k) == (1, 4, 2) { error } else { 0.0 };
                sign * (sum + spoilt)
            })
        };
        assert!(changed(0.0).is_ok(), "{:?}", changed(0.0).err());
        assert!(changed(1e-8).is_err());
    }
}
