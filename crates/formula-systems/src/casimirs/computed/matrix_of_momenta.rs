//! The matrix X(μ) of an algebra of matrices: [`MatrixOfMomenta`].

use nalgebra::DMatrix;
use std::sync::Arc;

/// The index a of a matrix, a row and a column, and the entry there.
type Entry = (usize, (usize, usize), f64);

/// The matrix X(μ) = Σ_a μ_a E^a of the coordinates μ_a of a summand.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MatrixOfMomenta {
    size: usize,
    /// The entries of the matrices E^a that are not zero, with the index a, the row and the column.
    entries: Arc<[Entry]>,
}

impl MatrixOfMomenta {
    /// Creates the matrix from the matrices E^a.
    pub(crate) fn new(duals: &[DMatrix<f64>]) -> Self {
        let size = duals.first().map_or(0, DMatrix::nrows);
        let places = (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
        let of = |(a, dual): (usize, &DMatrix<f64>)| {
            let entries = places.clone().map(|place| (a, place, dual[place]));
            entries.filter(|(_, _, weight)| *weight != 0.0).collect::<Vec<_>>()
        };
        Self { size, entries: duals.iter().enumerate().flat_map(of).collect() }
    }

    /// Returns the number of rows.
    pub(crate) const fn size(&self) -> usize {
        self.size
    }

    /// Returns X(μ).
    pub(crate) fn at(&self, own: &[f64]) -> DMatrix<f64> {
        let mut x = DMatrix::zeros(self.size, self.size);
        for &(a, place, weight) in self.entries.iter() {
            x[place] += own.get(a).copied().unwrap_or(f64::NAN) * weight;
        }
        x
    }

    /// Adds the derivatives ∂f/∂μ_a = Σ_ij ∂f/∂X_ij E^a_ij to slopes.
    pub(crate) fn pull_back(&self, of_matrix: &DMatrix<f64>, slopes: &mut [f64]) {
        for &(a, place, weight) in self.entries.iter() {
            if let Some(slope) = slopes.get_mut(a) {
                *slope += weight * of_matrix[place];
            }
        }
    }
}
