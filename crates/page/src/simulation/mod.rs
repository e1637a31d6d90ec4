//! A top that moves while its method and its step change.

pub(crate) mod clock;
pub(crate) mod measurement;
pub(crate) mod running_top;
