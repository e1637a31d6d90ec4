//! Curves, and panels of curves one above the other.

pub(crate) mod curve;
pub(crate) mod panels;
