//! One top, and many tops at once.

pub(crate) mod top;
pub(crate) mod many;
