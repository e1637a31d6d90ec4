//! What is done along one run: recording, states between samples, crossings.

pub(crate) mod schedule;
pub(crate) mod interruption;
pub(crate) mod recording;
pub(crate) mod dense;
pub(crate) mod crossings;
