//! The heavy top on a movable base.

pub(crate) mod top_on_base;
