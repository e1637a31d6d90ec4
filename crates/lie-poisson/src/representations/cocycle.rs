//! Cocycles of a Lie algebra with values in a representation: [`Cocycle`].

use crate::algebras::algebra::{LieAlgebra, Momentum};
use crate::representations::representation::{Representation, RepresentedElement};
use generic_scalars::{Covector, Real, State, Vector, larger, squaring_scale};
use nalgebra::{DMatrix, DVector, Vector1};
use std::sync::Arc;
use thiserror::Error;

/// The error returned for a linear map that is not a cocycle, or for a representation whose cocycles cannot be
/// computed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CocycleError {
    /// An entry of a matrix is infinite or not a number.
    #[error("the entry ({row}, {column}) = {value} of the {matrix} is not finite")]
    NotFinite {
        /// The matrix with this entry: that of the map, of a multiple of it, of the nearest cocycle, or of the
        /// cocycle equations.
        matrix: &'static str,
        /// The row of the entry.
        row: usize,
        /// The column of the entry.
        column: usize,
        /// The value of the entry.
        value: f64,
    },
    /// The map is not a cocycle.
    #[error(
        "not a cocycle: c[e{i}, e{j}] − e{i} c(e{j}) + e{j} c(e{i}) is {residual:e}, relative to |c| and to the \
         largest matrix element of the representation (allowed {allowed:e})"
    )]
    NotACocycle {
        /// The index of the first basis vector.
        i: usize,
        /// The index of the second basis vector.
        j: usize,
        /// The largest coordinate of the difference, relative to |c| and the largest matrix element.
        residual: f64,
        /// The relative rounding error that is allowed.
        allowed: f64,
    },
}

/// The ratio of two singular values below which the smaller one is a rounding error, and the largest residual of a
/// cocycle.
const TOLERANCE: f64 = 1e-10;

/// The size, relative to the target, below which an entry of a projection is a rounding error.
const ROUNDING: f64 = 1e-14;

/// A cocycle c of 𝔤 with values in a representation on V, a linear map 𝔤 → V with
///
/// ```text
/// c[ξ, η] = ξ c(η) − η c(ξ)
/// ```
///
/// The cocycles of the adjoint representation are the derivations of 𝔤, D[ξ, η] = [Dξ, η] + [ξ, Dη]. Those of the
/// coadjoint representation contain the closed two-forms on 𝔤, ω(ξ, ·). A cocycle extends the representation by one
/// dimension: see [`CocycleExtension`](crate::CocycleExtension).
///
/// Source: N. Jacobson, *Lie Algebras* (1962), §III.10 (one-cocycles) and §I.2 (derivations).
///
/// # Example
/// The dilation of Heisenberg's algebra, [e₀, e₁] = e₂:
/// ```
/// use lie_poisson::{Cocycle, InfinitesimalAdjoint, StructureConstants};
/// use nalgebra::Vector3;
/// let heisenberg = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
///     (0, 1, 2) => 1.0,
///     (1, 0, 2) => -1.0,
///     _ => 0.0,
/// })?;
/// let adjoint = InfinitesimalAdjoint(heisenberg);
/// let weights = [1.0, 1.0, 2.0];
/// let dilation = Cocycle::new(adjoint.clone(), |i, j| if i == j { weights[i] } else { 0.0 })?;
/// assert_eq!(dilation.apply(&Vector3::new(1.0, 2.0, 3.0)), Vector3::new(1.0, 2.0, 6.0));
/// // the identity is not a derivation, since [e₀, e₁] would be doubled
/// assert!(Cocycle::new(adjoint, |i, j| if i == j { 1.0 } else { 0.0 }).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Cocycle<R> {
    representation: R,
    /// The matrix of c by rows.
    entries: Arc<[f64]>,
}

impl<R: Representation> Cocycle<R> {
    /// The dimension of 𝔤.
    const N: usize = <RepresentedElement<R> as Vector>::DIM;

    /// The dimension of V.
    const D: usize = R::Space::<f64>::DIM;

    /// Creates the cocycle with the matrix c(i, j), the i-th coordinate of c(e_j).
    ///
    /// # Errors
    /// Returns [`CocycleError`] if an entry is not finite, or if the cocycle equation fails for some e_i, e_j by more
    /// than 10⁻¹⁰, relative to the largest entry of c and to the largest matrix element of the representation. The
    /// test divides by both sizes first, so that it has no units and neither overflows nor underflows.
    pub fn new(representation: R, c: impl Fn(usize, usize) -> f64) -> Result<Self, CocycleError> {
        let matrix = DMatrix::from_fn(Self::D, Self::N, c);
        finite("matrix of the cocycle", &matrix)?;
        let c = &matrix / nonzero(largest(&matrix));
        let (algebra, unit, matrices) = unit_matrices(&representation);
        for (i, j) in pairs(Self::N) {
            let bracket = algebra.bracket::<f64>(&Vector::basis(i), &Vector::basis(j));
            let bracket = DVector::from_fn(Self::N, |l, _| bracket.coordinate(l) / unit);
            let parts = &matrices[i] * c.column(j) - &matrices[j] * c.column(i);
            let residual = largest(&(&c * bracket - parts));
            if residual.is_nan() || residual > TOLERANCE {
                return Err(CocycleError::NotACocycle { i, j, residual, allowed: TOLERANCE });
            }
        }
        Ok(Self { representation, entries: matrix.transpose().iter().copied().collect() })
    }

    /// Returns the cocycle nearest to a linear map with the matrix target(i, j), in the sum of squares of the entries
    /// of the difference.
    ///
    /// It is the orthogonal projection of the map onto the null space of the linear cocycle equations, which is
    /// computed from the singular values of these equations. The result depends on the bases, but not on the size of
    /// the structure constants if the matrix elements have the same size.
    ///
    /// # Errors
    /// Returns [`CocycleError`] if an entry of the target, a structure constant or a matrix element is not finite, or
    /// if an entry of the cocycle would overflow.
    ///
    /// # Example
    /// The derivation nearest to the identity is the identity on an abelian algebra, and 0 on so(3), where all
    /// derivations have the trace 0:
    /// ```
    /// use lie_poisson::{Cocycle, InfinitesimalAdjoint, So3, StructureConstants, Vector};
    /// use nalgebra::{Vector2, Vector3};
    /// let abelian = InfinitesimalAdjoint(StructureConstants::<2>::new(|_, _, _| 0.0)?);
    /// let identity = |i, j| if i == j { 1.0 } else { 0.0 };
    /// let (v, w) = (Vector2::new(3.0, 4.0), Vector3::new(1.0, 2.0, 3.0));
    /// assert_eq!(Cocycle::nearest_to(abelian, identity)?.apply(&v), v);
    /// assert_eq!(Cocycle::nearest_to(InfinitesimalAdjoint(So3), identity)?.apply(&w), Vector3::zeros());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn nearest_to(
        representation: R,
        target: impl Fn(usize, usize) -> f64,
    ) -> Result<Self, CocycleError> {
        let (d, n) = (Self::D, Self::N);
        let matrix = DMatrix::from_fn(d, n, target);
        finite("target", &matrix)?;
        let equations = cocycle_equations(&representation);
        finite("equations of cocycles", &equations)?;
        let mut nearest = DVector::from_fn(d * n, |i, _| matrix[(i / n.max(1), i % n.max(1))]);
        let size = largest(&nearest);
        // Sums of large entries may overflow although the cocycle does not.
        let scale = squaring_scale(&Vector1::new(size));
        nearest *= scale;
        if !equations.is_empty() {
            let singular = equations.svd(false, true);
            let largest = singular.singular_values.iter().fold(0.0, |m, s| larger(m, *s));
            // A second projection removes the rounding errors of the first.
            for _ in 0..2 {
                let rows = singular.v_t.iter().flat_map(|v| v.row_iter());
                for (row, value) in rows.zip(singular.singular_values.iter()) {
                    if *value > largest * TOLERANCE {
                        let along = row.transpose();
                        nearest.axpy(-along.dot(&nearest), &along, 1.0);
                    }
                }
            }
        }
        let rounding = size * scale * ROUNDING;
        let cleared = |x: &f64| if x.abs() <= rounding { 0.0 } else { x / scale };
        let entries: Arc<[f64]> = nearest.iter().map(cleared).collect();
        finite("nearest cocycle", &DMatrix::from_row_slice(d, n, &entries))?;
        Ok(Self { representation, entries })
    }

    /// Returns the representation of the cocycle.
    pub const fn representation(&self) -> &R {
        &self.representation
    }

    /// Returns the matrix element c(i, j), the i-th coordinate of c(e_j), or zero beyond the dimensions.
    #[must_use]
    pub fn entry(&self, i: usize, j: usize) -> f64 {
        if i < Self::D && j < Self::N { self.entries[i * Self::N + j] } else { 0.0 }
    }

    /// Returns the cocycle sc.
    ///
    /// # Errors
    /// Returns [`CocycleError::NotFinite`] if an entry of sc is not finite.
    pub fn scaled(&self, s: f64) -> Result<Self, CocycleError> {
        let matrix = DMatrix::from_fn(Self::D, Self::N, |i, j| self.entry(i, j) * s);
        finite("scaled cocycle", &matrix)?;
        let entries = matrix.transpose().iter().copied().collect();
        Ok(Self { representation: self.representation.clone(), entries })
    }

    /// Returns the value c(ξ) of the cocycle.
    pub fn apply<T: Real>(&self, xi: &RepresentedElement<R, T>) -> R::Space<T> {
        R::Space::<T>::from_coordinates(|i| {
            (0..Self::N).fold(T::zero(), |sum, j| sum + xi.coordinate(j) * self.entry(i, j))
        })
    }

    /// Returns cᵀα ∈ 𝔤∗, with ⟨cᵀα, ξ⟩ = ⟨α, c(ξ)⟩.
    pub fn transpose_apply<T: Real>(
        &self,
        alpha: &Covector<R::Space<T>>,
    ) -> Momentum<R::Algebra, T> {
        Covector::from_coordinates(|j| {
            (0..Self::D).fold(T::zero(), |sum, i| sum + alpha.coordinate(i) * self.entry(i, j))
        })
    }
}

/// Returns the pairs of indices i < j below n.
fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(move |j| (0..j).map(move |i| (i, j)))
}

/// Returns the cocycle equations: one for each coordinate and each pair of basis vectors. The unknowns are the c(i,
/// j) by rows, in units of the largest matrix element.
fn cocycle_equations<R: Representation>(r: &R) -> DMatrix<f64> {
    let (d, n) = (R::Space::<f64>::DIM, <RepresentedElement<R> as Vector>::DIM);
    let (algebra, unit, matrices) = unit_matrices(r);
    let mut equations = DMatrix::zeros(d * n * n.saturating_sub(1) / 2, d * n);
    for (place, (i, j)) in pairs(n).enumerate() {
        let bracket = algebra.bracket::<f64>(&Vector::basis(i), &Vector::basis(j));
        for k in 0..d {
            let mut row = equations.row_mut(place * d + k);
            for l in 0..n {
                row[k * n + l] += bracket.coordinate(l) / unit;
            }
            for l in 0..d {
                row[l * n + j] -= matrices[i][(k, l)];
                row[l * n + i] += matrices[j][(k, l)];
            }
        }
    }
    equations
}

/// Returns the algebra, the largest matrix element, and the matrices of all v ↦ e_i v divided by it.
fn unit_matrices<R: Representation>(r: &R) -> (R::Algebra, f64, Vec<DMatrix<f64>>) {
    let unit = nonzero(largest_element(r));
    let n = <RepresentedElement<R> as Vector>::DIM;
    (r.algebra(), unit, (0..n).map(|i| matrix(r, i) / unit).collect())
}

/// Returns the largest |x| of the entries, or NaN if one is NaN.
fn largest<'a>(entries: impl IntoIterator<Item = &'a f64>) -> f64 {
    entries.into_iter().fold(0.0, |most, x| larger(most, x.abs()))
}

/// Returns a size, with 0 replaced by 1.
pub(crate) fn nonzero(size: f64) -> f64 {
    if size == 0.0 { 1.0 } else { size }
}

/// Returns the matrix of v ↦ e_i v.
pub(crate) fn matrix<R: Representation>(r: &R, i: usize) -> DMatrix<f64> {
    let d = R::Space::<f64>::DIM;
    let images: Vec<_> =
        (0..d).map(|j| r.act::<f64>(&Vector::basis(i), &Vector::basis(j))).collect();
    DMatrix::from_fn(d, d, |k, j| images[j].coordinate(k))
}

/// Returns the largest matrix element of a representation and of the brackets of its algebra, or NaN if one is NaN.
pub(crate) fn largest_element<R: Representation>(r: &R) -> f64 {
    let (d, n) = (R::Space::<f64>::DIM, <RepresentedElement<R> as Vector>::DIM);
    let act = |i: usize, j: usize| r.act::<f64>(&Vector::basis(i), &Vector::basis(j)).max_abs();
    let algebra = r.algebra();
    let bracket = |(i, j): (usize, usize)| {
        algebra.bracket::<f64>(&Vector::basis(i), &Vector::basis(j)).max_abs()
    };
    let actions = (0..n).flat_map(|i| (0..d).map(move |j| act(i, j)));
    actions.chain(pairs(n).map(bracket)).fold(0.0, larger)
}

/// Returns an error if an entry of the matrix is not finite.
fn finite(name: &'static str, matrix: &DMatrix<f64>) -> Result<(), CocycleError> {
    for (place, &value) in matrix.iter().enumerate() {
        if !value.is_finite() {
            let (row, column) = (place % matrix.nrows(), place / matrix.nrows());
            return Err(CocycleError::NotFinite { matrix: name, row, column, value });
        }
    }
    Ok(())
}
