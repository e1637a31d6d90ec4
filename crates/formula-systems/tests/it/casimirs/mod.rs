//! Casimirs of algebras by expression beyond those that the search finds.

mod matrix_casimirs;
mod motion_casimirs;
mod computed_casimirs;
