//! Along a trajectory: its samples, what lies between them, and events.

pub(crate) mod partial_step;
pub(crate) mod dense_output;
pub(crate) mod root_bracketing;
pub(crate) mod minimum;
pub(crate) mod crossing;
pub(crate) mod events;
