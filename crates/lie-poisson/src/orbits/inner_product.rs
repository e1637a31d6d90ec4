//! Inner products on the dual of a Lie algebra: [`InnerProduct`].

use generic_scalars::{Differential, Point, Real, State, Vector, VectorSpace, map_coordinates};
use nalgebra::DMatrix;
use thiserror::Error;

/// The part of two entries up to which they differ by rounding alone.
const ROUNDING: f64 = 1e-12;

/// The reason why a matrix is no inner product.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InnerProductError {
    /// The number of entries is no square.
    #[error("a matrix with as many rows as columns is needed, got {entries} entries")]
    NotSquare {
        /// The number of entries.
        entries: usize,
    },
    /// Two entries across the diagonal differ.
    #[error(
        "the matrix is not symmetric: entry ({row}, {column}) is {one}, and ({column}, {row}) is {other}"
    )]
    NotSymmetric {
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// The entry there.
        one: f64,
        /// The entry across the diagonal.
        other: f64,
    },
    /// The matrix is not positive definite, or an entry is no number.
    #[error("the matrix is not positive definite")]
    NotPositive,
}

/// An inner product on 𝔤∗, as the map ♯: 𝔤∗ → 𝔤 with ⟨α, β♯⟩ for the product of α and β, in coordinates.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, InnerProduct, InnerProductError, LiePoisson, So3};
/// use nalgebra::Vector3;
/// let weighted = InnerProduct::new(&[2.0, 1.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0, 1.0])?;
/// let sharp = weighted.sharp::<LiePoisson<So3>, f64>(&Covector(Vector3::new(1.0, 0.0, 4.0)));
/// assert_eq!(sharp, Vector3::new(2.0, 1.0, 4.0));
/// assert_eq!(InnerProduct::new(&[1.0, 2.0, 2.0, 1.0]), Err(InnerProductError::NotPositive));
/// # Ok::<(), InnerProductError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct InnerProduct {
    /// The rows of the matrix, one after the other; none for the unit matrix.
    rows: Vec<f64>,
    /// The rows of the lower triangular matrix L with LLᵀ equal to the matrix.
    root: Vec<f64>,
}

impl InnerProduct {
    /// Returns the inner product whose matrix in the coordinates of 𝔤∗ is the unit matrix.
    #[must_use]
    pub const fn euclidean() -> Self {
        Self { rows: Vec::new(), root: Vec::new() }
    }

    /// Creates an inner product from its symmetric, positive definite matrix, row by row. It is for spaces with as many
    /// coordinates as the matrix has rows.
    ///
    /// # Errors
    /// Returns [`InnerProductError`] if the matrix is not square, symmetric and positive definite.
    pub fn new(rows: &[f64]) -> Result<Self, InnerProductError> {
        let (entries, size) = (rows.len(), rows.len().isqrt());
        if size * size != entries || entries == 0 {
            return Err(InnerProductError::NotSquare { entries });
        }
        if !rows.iter().all(|entry| entry.is_finite()) {
            return Err(InnerProductError::NotPositive);
        }
        let matrix = DMatrix::from_row_slice(size, size, rows);
        for (i, j) in (0..size).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let (one, other) = (matrix[(i, j)], matrix[(j, i)]);
            if (one - other).abs() > ROUNDING * one.abs().max(other.abs()) {
                return Err(InnerProductError::NotSymmetric {
                    row: i + 1,
                    column: j + 1,
                    one,
                    other,
                });
            }
        }
        let root = matrix.cholesky().ok_or(InnerProductError::NotPositive)?.l();
        let root = (0..size).flat_map(|i| root.row(i).iter().copied().collect::<Vec<_>>());
        Ok(Self { rows: rows.to_vec(), root: root.collect() })
    }

    /// Returns the number of rows of the matrix; `None` for the unit matrix, which has any.
    #[must_use]
    pub fn dimension(&self) -> Option<usize> {
        (!self.rows.is_empty()).then(|| self.rows.len().isqrt())
    }

    /// Writes α♯ for coordinates whose number is known only when the program runs. It is NaN if the matrix has another number of
    /// rows.
    pub fn write_sharp<T: Real>(&self, alpha: &[T], sharp: &mut [T]) {
        write_product(&self.rows, sharp, |j| alpha.get(j).copied().unwrap_or_else(T::zero));
    }

    /// Writes Σ_k w_k e_k as [`orthonormal`](Self::orthonormal) returns it.
    pub fn write_orthonormal<T: Real>(&self, weights: &[T], element: &mut [T]) {
        write_product(&self.root, element, |k| weights.get(k).copied().unwrap_or_else(T::zero));
    }

    /// Returns α♯. It is NaN if the matrix has not as many rows as the space has coordinates.
    #[cfg_attr(optimised, inline(always))]
    #[must_use]
    pub fn sharp<P: VectorSpace, T: Real>(&self, alpha: &Point<P, T>) -> Differential<P, T> {
        if self.rows.is_empty() {
            return map_coordinates(
                alpha,
                #[cfg_attr(optimised, inline(always))]
                |x| x,
            );
        }
        product::<P, T>(
            &self.rows,
            #[cfg_attr(optimised, inline(always))]
            |j| alpha.coordinate(j),
        )
    }

    /// Returns Σ_k w_k e_k for elements e_k of 𝔤 that are orthonormal in the inner product on 𝔤, so that Σ_k e_k ⟨α, e_k⟩ = α♯.
    /// Weights that are left out are 0. It is NaN if the matrix has not as many rows as the space has coordinates.
    ///
    /// # Example
    /// ```
    /// use lie_poisson::{InnerProduct, LiePoisson, So3};
    /// use nalgebra::Vector3;
    /// let weighted = InnerProduct::new(&[4.0, 2.0, 0.0, 2.0, 2.0, 0.0, 0.0, 0.0, 1.0])?;
    /// let element = |weights: [f64; 3]| weighted.orthonormal::<LiePoisson<So3>, f64>(&weights);
    /// let sum: f64 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|w| element(w).x * element(w).y).iter().sum();
    /// assert_eq!(sum, 2.0); // the entry (1, 2) of the matrix
    /// # Ok::<(), lie_poisson::InnerProductError>(())
    /// ```
    #[cfg_attr(optimised, inline(always))]
    #[must_use]
    pub fn orthonormal<P: VectorSpace, T: Real>(&self, weights: &[T]) -> Differential<P, T> {
        let zero = T::zero();
        let mut element: Differential<P, T> = Vector::zero();
        element.set_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |k| weights.get(k).copied().unwrap_or(zero),
        );
        if self.rows.is_empty() {
            return element;
        }
        product::<P, T>(
            &self.root,
            #[cfg_attr(optimised, inline(always))]
            |k| element.coordinate(k),
        )
    }
}

/// Returns the product of a square matrix with a vector, as [`write_product`] writes it.
#[cfg_attr(optimised, inline(always))]
fn product<P: VectorSpace, T: Real>(
    rows: &[f64],
    vector: impl Fn(usize) -> T,
) -> Differential<P, T> {
    let mut product: Differential<P, T> = Vector::zero();
    let size = Point::<P, T>::DIM;
    product.set_coordinates(
        #[cfg_attr(optimised, inline(always))]
        |i| entry(rows, size, i, &vector),
    );
    product
}

/// Writes the product of a square matrix with a vector; NaN if it has another size. No rows are those of the unit matrix.
fn write_product<T: Real>(rows: &[f64], product: &mut [T], vector: impl Fn(usize) -> T) {
    let size = product.len();
    product.iter_mut().enumerate().for_each(|(i, x)| *x = entry(rows, size, i, &vector));
}

/// Returns an entry of the product of a square matrix with a vector.
#[cfg_attr(optimised, inline(always))]
fn entry<T: Real>(rows: &[f64], size: usize, i: usize, vector: &impl Fn(usize) -> T) -> T {
    if rows.is_empty() {
        return vector(i);
    }
    if rows.len() != size * size {
        return T::from_f64(f64::NAN);
    }
    let mut sum = T::zero();
    for (j, entry) in rows.iter().skip(i * size).take(size).enumerate() {
        sum += vector(j) * *entry;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_inner_product_is_refused_in_all_units() {
        use InnerProductError::{NotPositive, NotSymmetric};
        for place in 0..4 {
            let mut rows = [1.0, 0.5, 0.5, 1.0];
            assert!(InnerProduct::new(&rows).is_ok());
            rows[place] = f64::NAN;
            assert_eq!(InnerProduct::new(&rows), Err(NotPositive));
        }
        // A large block hides neither that another one is not symmetric, nor that it is indefinite.
        let with =
            |one, other| InnerProduct::new(&[1e20, 0.0, 0.0, 0.0, 1.0, one, 0.0, other, 1.0]);
        assert!(with(0.5, 0.5).is_ok());
        assert!(matches!(with(100.0, 0.5), Err(NotSymmetric { row: 3, column: 2, .. })));
        assert_eq!(with(2.0, 2.0), Err(NotPositive));
    }
}
