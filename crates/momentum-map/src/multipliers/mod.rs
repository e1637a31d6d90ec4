//! Multipliers: the linear equations that collective dynamics is, without a lift.

pub(crate) mod multiplier;
pub(crate) mod quaternions;
pub(crate) mod dual_quaternions;
pub(crate) mod complex_matrices;
pub(crate) mod powers;
pub(crate) mod products;
