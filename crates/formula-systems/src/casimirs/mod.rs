//! Casimirs: those of matrices and of motions, which complete those that were found.

pub(crate) mod matrices;
pub(crate) mod motions;
pub(crate) mod computed;
pub(crate) mod casimir;
pub(crate) mod summand;
pub(crate) mod span;
pub(crate) mod completion;
