//! Left and right actions of Lie groups, actions made from them, and cotangent lifts.

pub(crate) mod action;
pub(crate) mod represented_actions;
pub(crate) mod derived_actions;
pub(crate) mod cotangent_lift;
