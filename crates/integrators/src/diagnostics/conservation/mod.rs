//! Quantities along a run: those that stay, and those that change by a law.

pub(crate) mod invariant_size;
pub(crate) mod drift;
pub(crate) mod ensemble_growth;
pub(crate) mod balance;
