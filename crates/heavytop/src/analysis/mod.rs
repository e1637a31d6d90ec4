//! Poincaré sections of tops, and the nutation of any top.

pub(crate) mod section_error;
pub(crate) mod section_level;
pub(crate) mod surface;
pub(crate) mod section;
pub(crate) mod nutation;
