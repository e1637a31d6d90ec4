//! The elements of the algebra along which the momenta of open systems move.

pub(super) mod open_element;
mod element_field;
pub(super) mod open_reduced;
