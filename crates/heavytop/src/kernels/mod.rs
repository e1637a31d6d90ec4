//! Methods with formulas of their own for tops: the fast paths.

pub(crate) mod midpoint;
pub(crate) mod gauss_one;
pub(crate) mod gauss_many;
pub(crate) mod symmetric;
