//! Splittings of tops into exact flows.

pub(crate) mod principal_turn;
pub(crate) mod rotors;
pub(crate) mod symmetric_top;
