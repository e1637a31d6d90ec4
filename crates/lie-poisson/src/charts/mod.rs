//! Maps between an algebra and its group: the logarithm and the Cayley map.

pub(crate) mod logarithm;
pub(crate) mod cayley;
