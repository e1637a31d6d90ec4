//! The scalar trait with its masks, dual numbers, Stumpff functions, and linear equations.

pub(crate) mod mask;
pub(crate) mod blocks;
pub(crate) mod stumpff;
pub(crate) mod real;
pub(crate) mod sine;
mod plain_numbers;
pub(crate) mod dual_number;
pub(crate) mod linear_solve;
pub(crate) mod power_of_two;
