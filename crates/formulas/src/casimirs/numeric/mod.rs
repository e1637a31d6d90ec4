//! Linear algebra with tolerances, for structure constants that are rounded numbers.

pub(crate) mod balance;
pub(crate) mod semidefinite;
pub(crate) mod near_null_space;
pub(crate) mod numeric_brackets;
