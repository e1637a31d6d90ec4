//! Traces of powers and Pfaffians of the matrix of an algebra: [`PowerTrace`].

use super::matrix_of_momenta::MatrixOfMomenta;
use super::pfaffian_of_numbers::{pfaffian, pfaffian_slopes};
use crate::casimirs::matrices::invariant::{Invariant, times_i};
use nalgebra::DMatrix;
use std::sync::Arc;

/// An invariant of the matrix X(μ).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PowerTrace {
    pub(crate) matrix: MatrixOfMomenta,
    pub(crate) invariant: Invariant,
    /// The diagonal of the form η of a Pfaffian.
    pub(crate) form: Arc<[f64]>,
}

impl PowerTrace {
    /// Returns the value.
    pub(crate) fn value(&self, own: &[f64]) -> f64 {
        let x = self.matrix.at(own);
        match self.invariant {
            Invariant::Pfaffian(_) => pfaffian(&self.with_form(&x)),
            Invariant::Trace(k) => power_of(&x, k - k / 2).dot(&power_of(&x, k / 2).transpose()),
            Invariant::TurnedTrace(k) => {
                times_i(&power_of(&x, k - k / 2)).dot(&power_of(&x, k / 2).transpose())
            }
        }
    }

    /// Adds the derivatives to slopes: those of tr TXᵏ are k tr(T Xᵏ⁻¹ dX) for T = 1, and for T = J, with which X commutes.
    pub(crate) fn add_slopes(&self, own: &[f64], slopes: &mut [f64]) {
        let x = self.matrix.at(own);
        let of_matrix = match self.invariant {
            Invariant::Pfaffian(_) => {
                let of_form = pfaffian_slopes(&self.with_form(&x));
                DMatrix::from_fn(x.nrows(), x.ncols(), |i, j| self.sign(i) * of_form[(i, j)])
            }
            Invariant::Trace(k) => power_of(&x, k.saturating_sub(1)).transpose() * k as f64,
            Invariant::TurnedTrace(k) => {
                times_i(&power_of(&x, k.saturating_sub(1))).transpose() * k as f64
            }
        };
        self.matrix.pull_back(&of_matrix, slopes);
    }

    /// Returns ηX.
    fn with_form(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(x.nrows(), x.ncols(), |i, j| self.sign(i) * x[(i, j)])
    }

    fn sign(&self, row: usize) -> f64 {
        self.form.get(row).copied().unwrap_or(1.0)
    }
}

/// Returns a power of a matrix.
fn power_of(x: &DMatrix<f64>, exponent: usize) -> DMatrix<f64> {
    let mut power = DMatrix::identity(x.nrows(), x.nrows());
    for bit in (0..usize::BITS - exponent.leading_zeros()).rev() {
        power = &power * &power;
        if exponent >> bit & 1 == 1 {
            power = &power * x;
        }
    }
    power
}
