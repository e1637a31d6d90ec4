//! Tasks along one run: recording, states between samples, events, tangent vectors.

pub(crate) mod interruption;
pub(crate) mod accuracy;
pub(crate) mod event;
pub(crate) mod record;
pub(crate) mod recording;
pub(crate) mod dense;
pub(crate) mod growth;
pub(crate) mod following;
