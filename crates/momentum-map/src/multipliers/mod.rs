//! Multipliers: collective dynamics as linear equations, without a lift.

pub(crate) mod multiplier;
pub(crate) mod quaternions;
pub(crate) mod dual_quaternions;
pub(crate) mod complex_matrices;
pub(crate) mod powers;
pub(crate) mod products;
