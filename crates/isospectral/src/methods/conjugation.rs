//! The end of a step, [`Conjugation`], and steps of a copy.

use crate::matrices::large_matrix::LargeMatrix;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use collective_integrators::StepError;
use lie_poisson::State;

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
    /// Returns [`StepError::NotFinite`], and leaves W, if the result is not finite.
    pub(crate) fn by_exponential(
        &mut self,
        products: &mut Products,
        omega: &LargeSkewHermitian,
        w: &mut LargeSkewHermitian,
    ) -> Result<(), StepError> {
        products.exponential_minus_one(omega, &mut self.rotation);
        conjugate(products, &self.rotation, w, &mut self.next)
    }

    /// Replaces W by (1 + Z) W (1 + Z)*.
    ///
    /// # Errors
    /// Returns [`StepError::NotFinite`], and leaves W, if the result is not finite.
    pub(crate) fn by(
        &mut self,
        products: &mut Products,
        z: &LargeMatrix,
        w: &mut LargeSkewHermitian,
    ) -> Result<(), StepError> {
        conjugate(products, z, w, &mut self.next)
    }
}

fn conjugate(
    products: &mut Products,
    z: &LargeMatrix,
    w: &mut LargeSkewHermitian,
    next: &mut LargeSkewHermitian,
) -> Result<(), StepError> {
    products.conjugate(z, w, next);
    if !next.all_finite() {
        return Err(StepError::NotFinite);
    }
    w.move_from(next);
    Ok(())
}
