//! The stages of implicit methods: first guesses from the earlier steps, where these are forgotten, Newton's iteration and its
//! solutions that short steps lead to, and the terms whose round-off limits both.

pub(crate) mod checkpoints;
pub(crate) mod flat_state;
pub(crate) mod newton;
pub(crate) mod branch;
pub(crate) mod terms;
pub(crate) mod extrapolation;
pub(crate) mod history;
pub(crate) mod stage_memory;
pub(crate) mod lane_field;
