//! States between the samples of a trajectory, and events along it.

pub(crate) mod partial_step;
pub(crate) mod dense_output;
pub(crate) mod root_bracketing;
pub(crate) mod minimum;
pub(crate) mod event_values;
pub(crate) mod crossing;
pub(crate) mod pairs;
pub(crate) mod event_search;
pub(crate) mod events;
