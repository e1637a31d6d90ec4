//! Records along a motion.

pub(crate) mod deviation_record;
pub(crate) mod section_record;
