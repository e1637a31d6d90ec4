//! Derivations of a Lie algebra: [`Derivation`].

use crate::{Covector, LieAlgebra, Momentum, Real, Vector, larger};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;
use thiserror::Error;

/// The error of a linear map that is not a derivation, or of an algebra whose derivations cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DerivationError {
    /// An entry of the matrix, or a structure constant of the algebra, is infinite or not a number.
    #[error("the entry ({row}, {column}) = {value} of the {matrix} is not finite")]
    NotFinite {
        /// The matrix: that of D, or that of the equations of Leibniz' rule.
        matrix: &'static str,
        /// The row of the entry.
        row: usize,
        /// The column of the entry.
        column: usize,
        /// The value of the entry.
        value: f64,
    },
    /// Leibniz' rule fails for two basis vectors.
    #[error(
        "Leibniz' rule fails for e{i}, e{j} by {residual:e}, relative to |D| and the largest structure constant \
         (allowed {allowed:e})"
    )]
    Leibniz {
        /// The index of the first basis vector.
        i: usize,
        /// The index of the second basis vector.
        j: usize,
        /// The largest coordinate of D[e_i, e_j] − [De_i, e_j] − [e_i, De_j], relative to |D| |c|.
        residual: f64,
        /// The relative rounding error that is allowed.
        allowed: f64,
    },
}

/// The ratio of two singular values below which the smaller one is a rounding error.
const RANK_TOLERANCE: f64 = 1e-10;

/// The size below which an entry of a projection of the identity is a rounding error.
const ROUNDING: f64 = 1e-14;

/// A derivation D of a Lie algebra 𝔤, a linear map 𝔤 → 𝔤 with Leibniz' rule
///
/// ```text
/// D[ξ, η] = [Dξ, η] + [ξ, Dη]
/// ```
///
/// The derivations of 𝔤 are the Lie algebra of its automorphisms. Those of the form `ad_ξ` vanish on the centre; the
/// others extend 𝔤 by one dimension to 𝔤 ⋊ RD with [D, ξ] = Dξ.
///
/// Source: N. Jacobson, *Lie Algebras* (1962), §I.2.
///
/// # Example
/// The dilation of Heisenberg's algebra, [e₀, e₁] = e₂:
/// ```
/// use lie_poisson::{Derivation, StructureConstants};
/// use nalgebra::Vector3;
/// let heisenberg = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
///     (0, 1, 2) => 1.0,
///     (1, 0, 2) => -1.0,
///     _ => 0.0,
/// })?;
/// let weights = [1.0, 1.0, 2.0];
/// let dilation = Derivation::new(heisenberg.clone(), |i, j| if i == j { weights[i] } else { 0.0 })?;
/// assert_eq!(dilation.apply(&Vector3::new(1.0, 2.0, 3.0)), Vector3::new(1.0, 2.0, 6.0));
/// // the identity is not a derivation, since [e₀, e₁] would be doubled
/// assert!(Derivation::new(heisenberg, |i, j| if i == j { 1.0 } else { 0.0 }).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Derivation<A> {
    algebra: A,
    /// The matrix of D by rows.
    entries: Arc<[f64]>,
}

impl<A: LieAlgebra> Derivation<A> {
    /// The dimension of 𝔤.
    const N: usize = A::Element::<f64>::DIM;

    /// Creates the derivation with the matrix d(i, j), the i-th coordinate of D e_j.
    ///
    /// # Errors
    /// Returns [`DerivationError`] if an entry is not finite, or if Leibniz' rule fails for some e_i, e_j by more
    /// than 10⁻¹⁰, relative to the largest entry of D and to the largest structure constant.
    pub fn new(algebra: A, d: impl Fn(usize, usize) -> f64) -> Result<Self, DerivationError> {
        let n = Self::N;
        let matrix = DMatrix::from_fn(n, n, &d);
        finite("matrix of D", &matrix)?;
        let size = matrix.iter().fold(0.0, |most, x| larger(most, x.abs()));
        let derivation = Self { algebra, entries: matrix.transpose().iter().copied().collect() };
        let constants = largest_constant(&derivation.algebra);
        for (i, j) in pairs(n) {
            let (e_i, e_j) = (A::Element::<f64>::basis(i), A::Element::<f64>::basis(j));
            let bracket =
                |x: &A::Element<f64>, y: &A::Element<f64>| derivation.algebra.bracket::<f64>(x, y);
            let of_factors =
                bracket(&derivation.apply(&e_i), &e_j) + bracket(&e_i, &derivation.apply(&e_j));
            let defect = (derivation.apply(&bracket(&e_i, &e_j)) - of_factors).max_abs();
            let residual = if defect > 0.0 { defect / size / constants } else { defect };
            let allowed = RANK_TOLERANCE;
            if residual.is_nan() || residual > allowed {
                return Err(DerivationError::Leibniz { i, j, residual, allowed });
            }
        }
        Ok(derivation)
    }

    /// Returns the derivation nearest to the identity, in the sum of squares of the entries of D − 1.
    ///
    /// It is the orthogonal projection of the identity to the null space of the linear equations of Leibniz' rule,
    /// which is computed from the structure constants by their singular values. On an abelian algebra it is the
    /// identity. On a semisimple algebra it is 0, since every derivation has the form `ad_ξ` there and the trace 0.
    /// It depends on the basis, but not on the size of the structure constants.
    ///
    /// # Errors
    /// Returns [`DerivationError`] if a structure constant is not finite.
    ///
    /// # Example
    /// ```
    /// use lie_poisson::{Derivation, So3, StructureConstants, Vector};
    /// use nalgebra::{Vector2, Vector3};
    /// let abelian = StructureConstants::<2>::new(|_, _, _| 0.0)?;
    /// let (v, w) = (Vector2::new(3.0, 4.0), Vector3::new(1.0, 2.0, 3.0));
    /// assert_eq!(Derivation::nearest_to_identity(abelian)?.apply(&v), v);
    /// assert!(Derivation::nearest_to_identity(So3)?.apply(&w).max_abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn nearest_to_identity(algebra: A) -> Result<Self, DerivationError> {
        let n = Self::N;
        let equations = leibniz_equations(&algebra);
        finite("equations of Leibniz' rule", &equations)?;
        let identity = DVector::from_fn(n * n, |i, _| if i % (n + 1) == 0 { 1.0 } else { 0.0 });
        let mut projected = identity;
        if !equations.is_empty() {
            let singular = equations.svd(false, true);
            let largest = singular.singular_values.iter().fold(0.0, |m, s| larger(m, *s));
            // A second projection removes the rounding errors of the first.
            for _ in 0..2 {
                let rows = singular.v_t.iter().flat_map(|v| v.row_iter());
                for (row, value) in rows.zip(singular.singular_values.iter()) {
                    if *value > largest * RANK_TOLERANCE {
                        let along = row.transpose();
                        projected.axpy(-along.dot(&projected), &along, 1.0);
                    }
                }
            }
        }
        let cleared = |d: &f64| if d.abs() < ROUNDING { 0.0 } else { *d };
        Ok(Self { algebra, entries: projected.iter().map(cleared).collect() })
    }

    /// Returns the algebra 𝔤.
    pub const fn algebra(&self) -> &A {
        &self.algebra
    }

    /// Returns the matrix element d(i, j), the i-th coordinate of D e_j, or zero beyond the dimension.
    #[must_use]
    pub fn entry(&self, i: usize, j: usize) -> f64 {
        let inside = i.max(j) < Self::N;
        if inside { self.entries[i * Self::N + j] } else { 0.0 }
    }

    /// Returns the derivation sD.
    #[must_use]
    pub fn scaled(&self, s: f64) -> Self {
        let entries = self.entries.iter().map(|d| d * s).collect();
        Self { algebra: self.algebra.clone(), entries }
    }

    /// Returns Dξ.
    pub fn apply<T: Real>(&self, xi: &A::Element<T>) -> A::Element<T> {
        A::Element::<T>::from_coordinates(|i| self.sum(|j| self.entry(i, j), |j| xi.coordinate(j)))
    }

    /// Returns Dᵀμ, with ⟨Dᵀμ, ξ⟩ = ⟨μ, Dξ⟩.
    pub fn transpose_apply<T: Real>(&self, mu: &Momentum<A, T>) -> Momentum<A, T> {
        Covector::from_coordinates(|j| self.sum(|i| self.entry(i, j), |i| mu.coordinate(i)))
    }

    /// Returns Σ d(i) x(i).
    fn sum<T: Real>(&self, d: impl Fn(usize) -> f64, x: impl Fn(usize) -> T) -> T {
        (0..Self::N).fold(T::zero(), |sum, i| sum + x(i) * d(i))
    }
}

/// Returns the pairs of indices i < j below n.
fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(move |j| (0..j).map(move |i| (i, j)))
}

/// Returns the matrix of Leibniz' rule, an equation for each coordinate and each pair, and an unknown for each d(i, j)
/// by rows. The equations are in units of the largest structure constant.
fn leibniz_equations<A: LieAlgebra>(algebra: &A) -> DMatrix<f64> {
    let n = A::Element::<f64>::DIM;
    let size = largest_constant(algebra);
    let unit = if size > 0.0 { size } else { 1.0 };
    let e = A::Element::<f64>::basis;
    let bracket = |i: usize, j: usize| algebra.bracket::<f64>(&e(i), &e(j));
    let c = |i: usize, j: usize, k: usize| bracket(i, j).coordinate(k) / unit;
    let mut equations = DMatrix::zeros(n * n * n.saturating_sub(1) / 2, n * n);
    for (place, (i, j)) in pairs(n).enumerate() {
        for k in 0..n {
            let mut row = equations.row_mut(place * n + k);
            for l in 0..n {
                row[k * n + l] += c(i, j, l);
                row[l * n + i] -= c(l, j, k);
                row[l * n + j] -= c(i, l, k);
            }
        }
    }
    equations
}

/// Returns the largest structure constant |c[i][j][k]|, or NaN if one of them is NaN.
pub(crate) fn largest_constant<A: LieAlgebra>(algebra: &A) -> f64 {
    let e = A::Element::<f64>::basis;
    let norms =
        pairs(A::Element::<f64>::DIM).map(|(i, j)| algebra.bracket::<f64>(&e(i), &e(j)).max_abs());
    norms.fold(0.0, larger)
}

/// Refuses a matrix with an entry that is not finite.
fn finite(name: &'static str, matrix: &DMatrix<f64>) -> Result<(), DerivationError> {
    for (place, &value) in matrix.iter().enumerate() {
        if !value.is_finite() {
            let (row, column) = (place % matrix.nrows(), place / matrix.nrows());
            return Err(DerivationError::NotFinite { matrix: name, row, column, value });
        }
    }
    Ok(())
}
