//! Numbers: what a formula may ask of its scalar, and the scalars of one lane.

pub(crate) mod mask;
pub(crate) mod stumpff;
pub(crate) mod real;
pub(crate) mod dual_number;
pub(crate) mod linear_solve;
