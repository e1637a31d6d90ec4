//! The inverse inertia of a body and the fluid that moves with it.

use crate::error::{SystemError, require_finite};
use lie_poisson::{Pair, Real, constant_times, constant_transpose_times};
use nalgebra::{Matrix3, SMatrix, Vector3};

/// The largest difference of A and C from their transposes, relative to their largest entry.
const ASYMMETRY: f64 = 1e-12;

/// The positive definite matrix [A B; Bᵀ C], which maps (Π, P) to (Ω, v).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InverseInertia {
    a: Matrix3<f64>,
    b: Matrix3<f64>,
    c: Matrix3<f64>,
}

impl InverseInertia {
    /// Creates the matrix from its blocks.
    ///
    /// # Errors
    /// Returns [`SystemError`] if an entry is not finite, A or C is not symmetric, or the matrix is not
    /// positive definite.
    pub(crate) fn new(
        a: Matrix3<f64>,
        b: Matrix3<f64>,
        c: Matrix3<f64>,
    ) -> Result<Self, SystemError> {
        for (name, matrix) in [("A", &a), ("B", &b), ("C", &c)] {
            for &entry in matrix {
                require_finite(name, entry)?;
            }
        }
        for (name, matrix) in [("A", &a), ("C", &c)] {
            let defect = (matrix - matrix.transpose()).amax();
            if defect > ASYMMETRY * matrix.amax() {
                return Err(SystemError::NotSymmetric { name, defect, tolerance: ASYMMETRY });
            }
        }
        let inverse = Self { a, b, c };
        inverse.require_positive_definite()?;
        Ok(inverse)
    }

    /// Returns the velocities (Ω, v) = (AΠ + BP, BᵀΠ + CP).
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn velocity<T: Real>(
        &self,
        pi: &Vector3<T>,
        p: &Vector3<T>,
    ) -> Pair<Vector3<T>, Vector3<T>> {
        let Self { a, b, c } = self;
        Pair(
            constant_times(a, pi) + constant_times(b, p),
            constant_transpose_times(b, pi) + constant_times(c, p),
        )
    }

    /// Checks by Gaussian elimination that all pivots are positive.
    fn require_positive_definite(&self) -> Result<(), SystemError> {
        let Self { a, b, c } = self;
        let mut m = SMatrix::<f64, 6, 6>::from_fn(|i, j| match (i < 3, j < 3) {
            (true, true) => a[(i, j)],
            (true, false) => b[(i, j - 3)],
            (false, true) => b[(j, i - 3)],
            (false, false) => c[(i - 3, j - 3)],
        });
        for k in 0..6 {
            let pivot = m[(k, k)];
            if pivot.is_nan() || pivot <= 0.0 {
                let name = "pivot of [A B; Bᵀ C]";
                return Err(SystemError::NotPositive { name, value: pivot });
            }
            for i in k + 1..6 {
                let factor = m[(i, k)] / pivot;
                for j in k..6 {
                    m[(i, j)] -= factor * m[(k, j)];
                }
            }
        }
        Ok(())
    }
}
