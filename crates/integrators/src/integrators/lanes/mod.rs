//! Stages of one state side by side.

pub(crate) mod fastest_set;
pub(crate) mod field_in_lanes;
pub(crate) mod stages_in_lanes;
