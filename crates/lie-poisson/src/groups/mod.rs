//! The classical matrix groups with their Lie algebras.

pub(crate) mod abelian;
pub(crate) mod so2;
pub(crate) mod so3;
pub(crate) mod su2;
pub(crate) mod sl2;
pub(crate) mod unitary;
