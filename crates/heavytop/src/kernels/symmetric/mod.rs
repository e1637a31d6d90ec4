//! Splittings of many symmetric tops, one in each SIMD lane.

pub(crate) mod stumpff_polynomials;
pub(crate) mod drift_polynomials;
pub(crate) mod flows;
pub(crate) mod axial_turn;
pub(crate) mod steps;
pub(crate) mod symmetric_batch;
