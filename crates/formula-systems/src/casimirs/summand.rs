//! A direct summand whose Casimirs are known: [`Summand`].

use super::matrices::matrix_algebra::{MatrixAlgebra, Structure};
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
    /// sl(n, R) ⋉ Rⁿ: the algebra of matrices, whose coordinates are followed by those of the vector.
    Volumes(MatrixAlgebra),
}

impl Summand {
    /// Returns the summand whose coordinates come after so many others.
    pub(crate) fn after(&self, others: usize) -> Self {
        match self {
            Self::Matrices(algebra) => Self::Matrices(algebra.after(others)),
            Self::Motions(algebra) => Self::Motions(algebra.after(others)),
            Self::Volumes(algebra) => Self::Volumes(algebra.after(others)),
        }
    }

    /// Returns the semidirect product with one vector on which the basis acts by matrices, or `None` if its Casimirs are
    /// not known: it is that of so(p, q) or of sl(n, R) by its own matrices.
    pub(crate) fn with_vector(&self, matrices: &[DMatrix<f64>]) -> Option<Self> {
        let Self::Matrices(algebra) = self else { return None };
        if algebra.matrices() != matrices {
            return None;
        }
        match &algebra.structure {
            Structure::Form(form) => {
                let start = algebra.places().start;
                Some(Self::Motions(MotionAlgebra::new(start, Arc::clone(form))))
            }
            Structure::Real => {
                let is_special = algebra.places().len() + 1 == algebra.size().pow(2)
                    && matrices.iter().all(|matrix| matrix.trace() == 0.0);
                is_special.then(|| Self::Volumes(algebra.clone()))
            }
            Structure::Complex | Structure::Symplectic => None,
        }
    }
}
