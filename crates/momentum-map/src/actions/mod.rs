//! Actions of Lie groups, left and right, those made from others, and cotangent lifts.

pub(crate) mod action;
pub(crate) mod derived_actions;
pub(crate) mod cotangent_lift;
