//! The Casimirs of so(p, q) ⋉ Rⁿ with one vector, n = p + q: the wedge products of the vector with the form of the rotations.

pub(crate) mod motion_algebra;
pub(crate) mod wedge_product;
pub(crate) mod wedge_formulas;
