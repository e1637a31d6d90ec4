//! A direct summand whose Casimirs are known: [`Summand`].

use super::matrix_algebra::{MatrixAlgebra, Structure};
use super::motions::motion_algebra::MotionAlgebra;
use nalgebra::DMatrix;
use std::sync::Arc;

/// A direct summand whose Casimirs are known without a search.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Summand {
    /// An algebra of matrices.
    Matrices(MatrixAlgebra),
    /// so(p, q) ⋉ Rⁿ
    Motions(MotionAlgebra),
}

impl Summand {
    /// Returns the summand whose coordinates come after so many others.
    pub(crate) fn after(&self, others: usize) -> Self {
        match self {
            Self::Matrices(algebra) => Self::Matrices(algebra.after(others)),
            Self::Motions(algebra) => Self::Motions(algebra.after(others)),
        }
    }

    /// Returns the semidirect product with one vector on which the basis acts by matrices, or `None` if its Casimirs are
    /// not known: it is that of so(p, q) by its own matrices.
    pub(crate) fn with_vector(&self, matrices: &[DMatrix<f64>]) -> Option<Self> {
        let Self::Matrices(algebra) = self else { return None };
        let Structure::Form(form) = &algebra.structure else { return None };
        let motions = MotionAlgebra::new(algebra.places().start, Arc::clone(form));
        (algebra.matrices() == matrices).then_some(Self::Motions(motions))
    }
}
