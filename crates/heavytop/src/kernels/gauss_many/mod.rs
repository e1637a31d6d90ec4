//! Collective Gauss methods of many tops, one in each SIMD lane.

pub(crate) mod spinor_field;
pub(crate) mod spinor_step;
pub(crate) mod gauss_batch;
