//! Maps between an algebra and its group: the logarithm, and Cayley's.

pub(crate) mod logarithm;
pub(crate) mod cayley;
