//! The Casimirs of algebras of matrices as formulas: traces of powers, and Pfaffians.

pub(crate) mod matrix_algebra;
pub(crate) mod invariant;
pub(crate) mod symmetry;
pub(crate) mod expression_matrix;
pub(crate) mod pfaffian;
pub(crate) mod formulas;
