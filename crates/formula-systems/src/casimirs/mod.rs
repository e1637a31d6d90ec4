//! The Casimirs that algebras of matrices have by their matrices, beside those that are found from the brackets: traces of
//! powers and Pfaffians, and with a vector squares of wedge products.

pub(crate) mod matrix_algebra;
pub(crate) mod invariant;
pub(crate) mod symmetry;
pub(crate) mod expression_matrix;
pub(crate) mod pfaffian;
pub(crate) mod formulas;
pub(crate) mod motions;
pub(crate) mod summand;
pub(crate) mod span;
pub(crate) mod completion;
