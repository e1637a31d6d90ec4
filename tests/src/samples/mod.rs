//! Points, elements and Hamiltonians to test with, over floating-point and rational numbers.

pub(crate) mod derived;
pub(crate) mod quadratic;
pub(crate) mod rational;
pub(crate) mod strategies;
