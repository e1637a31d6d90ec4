//! The stages of implicit methods: first guesses from the steps before, where these are forgotten, and Newton's
//! iteration.

pub(crate) mod checkpoints;
pub(crate) mod newton;
pub(crate) mod extrapolation;
pub(crate) mod history;
pub(crate) mod stage_memory;
pub(crate) mod lane_field;
