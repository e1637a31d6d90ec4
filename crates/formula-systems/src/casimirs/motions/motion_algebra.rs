//! The rotations and translations of a space with a form, as a summand: [`MotionAlgebra`].

use core::ops::Range;
use std::sync::Arc;

/// A direct summand so(p, q) ⋉ Rⁿ, n = p + q, with consecutive coordinates: L_ij, i < j, of the matrices η_i E_ji − η_j E_ij,
/// and then Γ_i of the basis vectors of Rⁿ.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MotionAlgebra {
    first: usize,
    /// The diagonal entries ±1 of η.
    form: Arc<[f64]>,
}

impl MotionAlgebra {
    /// Creates the algebra of a form, whose coordinates begin at `first`.
    pub(crate) const fn new(first: usize, form: Arc<[f64]>) -> Self {
        Self { first, form }
    }

    /// Returns the summand whose coordinates come after so many others.
    pub(crate) fn after(&self, others: usize) -> Self {
        Self { first: self.first + others, form: Arc::clone(&self.form) }
    }

    /// Returns the form η.
    pub(crate) const fn form(&self) -> &Arc<[f64]> {
        &self.form
    }

    /// Returns the dimension of the space.
    pub(crate) fn size(&self) -> usize {
        self.form.len()
    }

    /// Returns the places of all its coordinates.
    pub(crate) fn places(&self) -> Range<usize> {
        self.first..self.vectors().end
    }

    /// Returns the places of the L_ij.
    pub(crate) fn rotations(&self) -> Range<usize> {
        let n = self.size();
        self.first..self.first + n * n.saturating_sub(1) / 2
    }

    /// Returns the places of the Γ_i.
    pub(crate) fn vectors(&self) -> Range<usize> {
        let start = self.rotations().end;
        start..start + self.size()
    }
}
