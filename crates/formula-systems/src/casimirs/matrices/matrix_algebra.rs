//! A Lie algebra by its matrices, as a summand: [`MatrixAlgebra`].

use core::ops::Range;
use nalgebra::DMatrix;
use std::sync::Arc;

/// The largest entry, relative to the largest of all, of matrices that were computed from Gell-Mann's that counts as zero.
/// It is some hundred roundings.
const ROUNDING: f64 = 1e-13;

/// What all matrices of an algebra respect, besides their bracket.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Structure {
    /// Nothing.
    Real,
    /// The product J with i on Cⁿ, in the coordinates Re v₁, Im v₁, Re v₂, … of R²ⁿ, and the Hermitian product there.
    Complex,
    /// The form Ω = [0 1; −1 0]: the products Ωξ are symmetric.
    Symplectic,
    /// A form η with diagonal entries ±1: the products ηξ are antisymmetric. The matrices are η_i E_ji − η_j E_ij, i < j, in
    /// the order of their indices.
    Form(Arc<[f64]>),
}

/// A direct summand that is an algebra of matrices E_a, one for each of its coordinates μ_a, which are consecutive.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MatrixAlgebra {
    first: usize,
    matrices: Arc<[DMatrix<f64>]>,
    pub(crate) structure: Structure,
}

impl MatrixAlgebra {
    pub(crate) fn new(matrices: &[DMatrix<f64>], structure: Structure) -> Self {
        Self { first: 0, matrices: matrices.into(), structure }
    }

    /// Returns the summand whose coordinates come after so many others.
    pub(crate) fn after(&self, others: usize) -> Self {
        Self { first: self.first + others, ..self.clone() }
    }

    /// Returns the places of its coordinates.
    pub(crate) fn places(&self) -> Range<usize> {
        self.first..self.first + self.matrices.len()
    }

    /// Returns the matrices.
    pub(crate) fn matrices(&self) -> &[DMatrix<f64>] {
        &self.matrices
    }

    /// Returns the number of rows of the matrices.
    pub(crate) fn size(&self) -> usize {
        self.matrices.first().map_or(0, DMatrix::nrows)
    }

    /// Returns the matrices E^a = Σ_b G^ab E_b with tr(E^a E_b) = δ_ab, where G^ab is the inverse of the trace form
    /// G_ab = tr(E_a E_b), or `None` if the form is degenerate.
    pub(crate) fn duals(&self) -> Option<Vec<DMatrix<f64>>> {
        let (count, size) = (self.matrices.len(), self.size());
        let turned: Vec<DMatrix<f64>> = self.matrices.iter().map(DMatrix::transpose).collect();
        let form = DMatrix::from_fn(count, count, |a, b| turned[a].dot(&self.matrices[b]));
        let largest = form.amax();
        let inverse = form.map(|x| rounded(x, largest)).try_inverse()?;
        let dual = |a: usize| {
            let weights = (0..count).map(|b| inverse[(a, b)]);
            let terms = weights.zip(self.matrices.iter());
            let nonzero = terms.filter(|(weight, _)| *weight != 0.0);
            let sum =
                nonzero.fold(DMatrix::zeros(size, size), |sum, (weight, of)| sum + of * weight);
            let largest = sum.amax();
            sum.map(|x| rounded(x, largest))
        };
        Some((0..count).map(dual).collect())
    }
}

/// Returns a number, or 0 if it is a rounding error of the largest one.
fn rounded(x: f64, largest: f64) -> f64 {
    if x.abs() <= ROUNDING * largest { 0.0 } else { x }
}
