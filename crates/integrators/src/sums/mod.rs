//! Sums and products of vectors whose rounding errors are unbiased, or kept.

pub(crate) mod halves;
pub(crate) mod two_sum;
pub(crate) mod exact_combination;
