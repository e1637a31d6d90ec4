//! The invariant polynomials of matrices: [`Invariant`].

use super::matrix_algebra::{MatrixAlgebra, Structure};
use nalgebra::{DMatrix, DVector};

/// A polynomial of X in an algebra 𝔤 of matrices that does not change under X ↦ gXg⁻¹.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Invariant {
    /// tr Xᵏ
    Trace(usize),
    /// tr(J Xᵏ) with the product J with i: on Cⁿ, where X is anti-Hermitian, it takes the place of tr Xᵏ for odd k.
    TurnedTrace(usize),
    /// The Pfaffian of ηX of degree m, for matrices of 2m rows.
    Pfaffian(usize),
}

impl Invariant {
    /// Returns the invariants of an algebra of which all others are functions, in the order of their degrees.
    pub(crate) fn all(algebra: &MatrixAlgebra) -> Vec<Self> {
        let size = algebra.size();
        let trace = |k: usize| match algebra.structure {
            Structure::Complex if !k.is_multiple_of(2) => Self::TurnedTrace(k),
            _ => Self::Trace(k),
        };
        let highest = if algebra.structure == Structure::Complex { size / 2 } else { size };
        let mut all: Vec<Self> = (1..=highest).map(trace).collect();
        if matches!(algebra.structure, Structure::Form(_)) && size.is_multiple_of(2) {
            all.push(Self::Pfaffian(size / 2));
            all.sort_by_key(|invariant| invariant.degree());
        }
        all
    }

    /// Returns the degree.
    pub(crate) const fn degree(self) -> usize {
        match self {
            Self::Trace(k) | Self::TurnedTrace(k) | Self::Pfaffian(k) => k,
        }
    }

    /// Returns what a reader is shown for the invariant of a matrix with this text.
    pub(crate) fn text(self, matrix: &str) -> String {
        match self {
            Self::Trace(k) => format!("tr {matrix}^{k}"),
            Self::TurnedTrace(k) => format!("tr J {matrix}^{k}"),
            Self::Pfaffian(_) => format!("Pf {matrix}"),
        }
    }

    /// Returns a multiple of the differential at X = Σ_a μ_a E^a with respect to the coordinates μ_a, of size 1 at most, or
    /// `None` where X has no inverse.
    ///
    /// With P = Xᵏ⁻¹ it is tr(P E^a), or tr(JP E^a). Of Pf A it is ½ Pf A tr(A⁻¹ dA), so that P = X⁻¹.
    pub(crate) fn direction(
        self,
        x: &DMatrix<f64>,
        duals: &[DMatrix<f64>],
    ) -> Option<DVector<f64>> {
        let power = |k: usize| (1..k).fold(DMatrix::identity(x.nrows(), x.nrows()), |p, _| p * x);
        let factor = match self {
            Self::Trace(k) => power(k),
            Self::TurnedTrace(k) => times_i(&power(k)),
            Self::Pfaffian(_) => x.clone().try_inverse()?,
        };
        let factor = factor.transpose();
        let largest = duals.iter().map(DMatrix::norm).fold(0.0, f64::max) * factor.norm();
        let slopes = duals.iter().map(|dual| factor.dot(dual) / largest);
        Some(DVector::from_iterator(duals.len(), slopes))
    }
}

/// Returns JM, whose rows are −Im and Re of M where those of M are Re and Im.
pub(crate) fn times_i(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| match row % 2 {
        0 => -matrix[(row + 1, column)],
        _ => matrix[(row - 1, column)],
    })
}
