//! The end of a step, [`Conjugation`], and steps of a copy.

use crate::matrices::large_matrix::LargeMatrix;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use collective_integrators::StepError;
use lie_poisson::{State, larger};

/// The largest deviation of the squared length of a column of a unitary matrix from 1.
///
/// If a generator times the step is so large that its rounding errors have this size, the iteration converges to a
/// matrix that is not unitary. A loose tolerance of the iteration does not cause this.
const LARGEST_DEFECT: f64 = 1e-3;

/// The step W₁ = (1 + Z) W (1 + Z)* with which each method ends, and its storage.
#[derive(Clone, Debug)]
pub(crate) struct Conjugation {
    next: LargeSkewHermitian,
    rotation: LargeMatrix,
}

impl Conjugation {
    /// Creates the storage for matrices of a size.
    pub(crate) fn new(size: usize) -> Self {
        Self { next: LargeSkewHermitian::zeros(size), rotation: LargeMatrix::zeros(size) }
    }

    /// Replaces W by exp(Ω) W exp(−Ω).
    ///
    /// # Errors
    /// Returns [`StepError::NotFinite`], and leaves W unchanged, if the result is not finite.
    pub(crate) fn by_exponential(
        &mut self,
        products: &mut Products,
        omega: &LargeSkewHermitian,
        w: &mut LargeSkewHermitian,
    ) -> Result<(), StepError> {
        products.exponential_minus_one(omega, &mut self.rotation);
        conjugate(products, &self.rotation, w, &mut self.next)
    }

    /// Replaces W by (1 + Z) W (1 + Z)*, for a 1 + Z that was found in the given number of iterations.
    ///
    /// # Errors
    /// Returns [`StepError::NotFinite`], and leaves W unchanged, if the result is not finite, and
    /// [`StepError::NotConverged`] if 1 + Z is far from unitary.
    pub(crate) fn by(
        &mut self,
        products: &mut Products,
        (z, iterations): (&LargeMatrix, usize),
        w: &mut LargeSkewHermitian,
    ) -> Result<(), StepError> {
        let residual = unit_column_defect(z);
        if residual > LARGEST_DEFECT {
            let required = LARGEST_DEFECT;
            return Err(StepError::NotConverged { residual, required, iterations });
        }
        conjugate(products, z, w, &mut self.next)
    }
}

/// Returns the largest deviation of the squared lengths of the columns of 1 + Z from 1, which is 0 if 1 + Z is unitary.
fn unit_column_defect(z: &LargeMatrix) -> f64 {
    // There is no column of length 0.
    let size = z.size().max(1);
    let columns = z.real().chunks_exact(size).zip(z.imaginary().chunks_exact(size));
    columns.enumerate().fold(0.0, |largest, (k, (real, imaginary))| {
        let squares: f64 = real.iter().zip(imaginary).map(|(x, y)| x * x + y * y).sum();
        larger(largest, (squares + 2.0 * real[k]).abs())
    })
}

fn conjugate(
    products: &mut Products,
    z: &LargeMatrix,
    w: &mut LargeSkewHermitian,
    next: &mut LargeSkewHermitian,
) -> Result<(), StepError> {
    products.conjugate(z, w, next);
    if !next.is_finite() {
        return Err(StepError::NotFinite);
    }
    w.move_from(next);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;

    #[test]
    fn the_defect_is_that_of_the_longest_or_shortest_column() {
        let defect = |entries: [(usize, usize, f64, f64); 2]| {
            let mut z = LargeMatrix::zeros(3);
            entries.iter().for_each(|&(j, k, re, im)| z.set(j, k, Complex::new(re, im)));
            unit_column_defect(&z)
        };
        // 1 + Z has the columns (1, 0, 0), (0, 1, ½ i) and (0, 0, 1), and then (½, 0, 0) and (0, 1.25, 0).
        assert_eq!(defect([(2, 1, 0.0, 0.5), (0, 0, 0.0, 0.0)]), 0.25);
        assert_eq!(defect([(0, 0, -0.5, 0.0), (1, 1, 0.25, 0.0)]), 0.75);
        // A rotation by a right angle has none.
        let mut rotation = LargeMatrix::zeros(2);
        for (j, k, x) in [(0, 0, -1.0), (1, 1, -1.0), (0, 1, 1.0), (1, 0, -1.0)] {
            rotation.set(j, k, Complex::new(x, 0.0));
        }
        assert_eq!(unit_column_defect(&rotation), 0.0);
    }
}
