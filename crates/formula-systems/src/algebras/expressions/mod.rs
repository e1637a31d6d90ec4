//! Lie algebras by expression, such as `so(3)^64` or `so(4) ⋉ R4`: the text, the algebras that it names, and what it makes
//! of them.

pub(crate) mod part;
mod given_representation;
pub(crate) mod matrices;
pub(crate) mod kinematics;
pub(crate) mod atoms;
pub(crate) mod tokens;
pub(crate) mod parser;
