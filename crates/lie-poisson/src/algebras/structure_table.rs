//! Lie algebras whose dimension is known only when the program runs: [`StructureTable`].

use crate::algebras::jacobi::Brackets;
use generic_scalars::{Real, larger};
use std::sync::Arc;
use thiserror::Error;

/// The error returned for a table of numbers that does not define the bracket of a Lie algebra.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StructureError {
    /// A structure constant is infinite or not a number.
    #[error("the structure constant c[{i}][{j}][{k}] = {value} is not finite")]
    NotFinite {
        /// The first index of the bracket.
        i: usize,
        /// The second index of the bracket.
        j: usize,
        /// The index of the coordinate.
        k: usize,
        /// The value of the constant.
        value: f64,
    },
    /// The bracket is not antisymmetric: [e_i, e_j] ≠ −[e_j, e_i].
    #[error(
        "not antisymmetric: [e{i}, e{j}] + [e{j}, e{i}] has the coordinate {residual:e} at {k}"
    )]
    NotAntisymmetric {
        /// The first index of the bracket.
        i: usize,
        /// The second index of the bracket.
        j: usize,
        /// The index of the coordinate.
        k: usize,
        /// The sum that should be zero.
        residual: f64,
    },
    /// The Jacobi identity fails: the cyclic sum of [e_i, [e_j, e_k]] is not zero.
    ///
    /// The residual and the bound are relative to the size of the terms of this sum.
    #[error(
        "the Jacobi identity fails for e{i}, e{j}, e{k} by {residual:e} of the size of its terms \
         (allowed {allowed:e})"
    )]
    Jacobi {
        /// The index of the first basis vector.
        i: usize,
        /// The index of the second basis vector.
        j: usize,
        /// The index of the third basis vector.
        k: usize,
        /// The largest coordinate of the cyclic sum, relative to the size of its terms.
        residual: f64,
        /// The relative rounding error that is allowed.
        allowed: f64,
    },
    /// An index is not smaller than the dimension.
    #[error("a structure constant has the index {index}; those of dimension {dimension} end at {last}", last = .dimension.saturating_sub(1))]
    IndexTooLarge {
        /// The index that is too large, from 0.
        index: usize,
        /// The dimension of the algebra.
        dimension: usize,
    },
}

/// The structure constant of the indices i, j, k, from 0: the coordinate `value` of [e_i, e_j] at e_k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StructureEntry {
    /// The first index of the bracket.
    pub i: usize,
    /// The second index of the bracket.
    pub j: usize,
    /// The index of the coordinate.
    pub k: usize,
    /// The coordinate of [e_i, e_j] at e_k.
    pub value: f64,
}

/// A Lie algebra from its structure constants, `[e_i, e_j] = Σ_k c[i][j][k] e_k`, of a dimension that is known only when the
/// program runs. Elements of 𝔤 and 𝔤∗ are slices of coordinates.
///
/// It keeps the constants that are not zero, so that an algebra of a hundred dimensions costs what its brackets cost.
/// [`StructureConstants`](crate::StructureConstants) is the same for a dimension that the compiler knows.
///
/// # Example
/// ```
/// use lie_poisson::{StructureEntry, StructureTable};
/// // Heisenberg: [e₀, e₁] = e₂
/// let constant = |i, j, value| StructureEntry { i, j, k: 2, value };
/// let heisenberg = StructureTable::new(3, [constant(0, 1, 1.0), constant(1, 0, -1.0)])?;
/// let mut rate = [0.0; 3];
/// heisenberg.coadjoint(&[2.0, 3.0, 0.0], &[0.0, 0.0, 5.0], &mut rate);
/// assert_eq!(rate, [-15.0, 10.0, 0.0]);
/// assert!(StructureTable::new(3, [constant(0, 1, 1.0)]).is_err()); // not antisymmetric
/// # Ok::<(), lie_poisson::StructureError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StructureTable {
    dimension: usize,
    /// The constants that are not zero, in the order of their indices.
    entries: Arc<[StructureEntry]>,
    /// The same constants for each j, whose terms are one coordinate of ad∗_ξ μ.
    terms: Arc<[Box<[StructureEntry]>]>,
}

impl StructureTable {
    /// Creates the algebra of a dimension from its structure constants, those with i > j too. What is not listed is zero, and
    /// what is listed twice counts once.
    ///
    /// # Errors
    /// Returns [`StructureError`] if an index is too large, if a constant is not finite, if the bracket is not exactly
    /// antisymmetric, or if the Jacobi identity fails for some e_i, e_j, e_k. Each coordinate m of the cyclic sum must vanish
    /// to within 12 N ε times the size of its own terms, whatever the size of the other constants, in N dimensions:
    ///
    /// ```text
    /// Σ_cyc Σ_l ( |[e_j, e_k]| |c[i][l][m]| + |c[j][k][l]| |[e_i, e_l]| ),    |·| the maximum norm
    /// ```
    ///
    /// Constants may have rounding errors of a few ε relative to their bracket [e_i, e_j], for example after a
    /// numerical change of basis.
    pub fn new(
        dimension: usize,
        constants: impl IntoIterator<Item = StructureEntry>,
    ) -> Result<Self, StructureError> {
        let nonzero = constants.into_iter().filter(|entry| entry.value != 0.0);
        let mut entries: Vec<StructureEntry> = nonzero.collect();
        entries.sort_by_key(place);
        entries.dedup();
        let mut terms = vec![Vec::new(); dimension];
        for entry in &entries {
            if let Some(terms) = terms.get_mut(entry.j) {
                terms.push(*entry);
            }
        }
        let terms = terms.into_iter().map(Vec::into_boxed_slice).collect();
        let table = Self { dimension, entries: entries.into(), terms };
        table.check()?;
        Ok(table)
    }

    /// Returns the dimension of the algebra.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns the constants that are not zero, in the order of their indices, those with i > j too.
    #[must_use]
    pub fn entries(&self) -> &[StructureEntry] {
        &self.entries
    }

    /// Returns the constant `c[i][j][k]`, or zero for indices beyond the dimension.
    #[must_use]
    pub fn constant(&self, i: usize, j: usize, k: usize) -> f64 {
        let found = self.entries.binary_search_by_key(&(i, j, k), place);
        found.ok().and_then(|at| self.entries.get(at)).map_or(0.0, |entry| entry.value)
    }

    /// Writes ad∗_ξ μ, with the coordinates `Σ c[i][j][k] ξ_i μ_k`. Coordinates that a slice lacks count as zero.
    #[cfg_attr(optimised, inline(always))]
    pub fn coadjoint<T: Real>(&self, xi: &[T], mu: &[T], rate: &mut [T]) {
        rate.fill(T::zero());
        for (rate, terms) in rate.iter_mut().zip(&*self.terms) {
            let mut sum = T::zero();
            for &StructureEntry { i, k, value, .. } in terms {
                if let (Some(xi), Some(mu)) = (xi.get(i), mu.get(k)) {
                    sum += *xi * (*mu * value);
                }
            }
            *rate = sum;
        }
    }

    /// Checks that the constants are those of a Lie algebra.
    fn check(&self) -> Result<(), StructureError> {
        let dimension = self.dimension;
        for &StructureEntry { i, j, k, value } in &*self.entries {
            if let Some(index) = [i, j, k].into_iter().find(|&index| index >= dimension) {
                return Err(StructureError::IndexTooLarge { index, dimension });
            }
            if !value.is_finite() {
                return Err(StructureError::NotFinite { i, j, k, value });
            }
        }
        // A constant with two values cannot be the negative of one.
        for pair in self.entries.windows(2) {
            if let [one, other] = pair
                && place(one) == place(other)
            {
                let (i, j, k) = place(one);
                let residual = one.value - other.value;
                return Err(StructureError::NotAntisymmetric { i, j, k, residual });
            }
        }
        for &StructureEntry { i, j, k, value } in &*self.entries {
            let residual = value + self.constant(j, i, k);
            if residual != 0.0 {
                return Err(StructureError::NotAntisymmetric { i, j, k, residual });
            }
        }
        self.check_jacobi()
    }

    /// Checks the Jacobi identity for all triples of basis vectors.
    fn check_jacobi(&self) -> Result<(), StructureError> {
        let dimension = self.dimension;
        // 3N products of two constants, each rounded three times, and their sum.
        let allowed = 12.0 * dimension as f64 * f64::EPSILON;
        let entries = self.entries.iter().map(|entry| (entry.i, entry.j, entry.k, entry.value));
        let table = Brackets::new(dimension, entries);
        // The cyclic sum of an antisymmetric bracket is alternating.
        for i in 0..dimension {
            for (j, k) in (i + 1..dimension).flat_map(|j| (j + 1..dimension).map(move |k| (j, k))) {
                if [(i, j), (j, k), (k, i)].iter().all(|&(a, b)| table.norm(a, b).is_zero()) {
                    continue;
                }
                let residuals = table.reached([i, j, k]);
                let residuals = residuals.into_iter().map(|m| table.jacobi_residual([i, j, k], m));
                let residual = residuals.fold(0.0, larger);
                if residual.is_nan() || residual > allowed {
                    return Err(StructureError::Jacobi { i, j, k, residual, allowed });
                }
            }
        }
        Ok(())
    }
}

/// Returns the place of a constant in the order of the indices.
fn place(entry: &StructureEntry) -> (usize, usize, usize) {
    (entry.i, entry.j, entry.k)
}
