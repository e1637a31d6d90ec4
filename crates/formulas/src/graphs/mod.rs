//! Expressions as graphs in which equal parts are one node: simplification, derivatives, and the meaning of a text.

pub(crate) mod graph;
pub(crate) mod simplification;
pub(crate) mod composed;
pub(crate) mod elaboration;
pub(crate) mod guards;
pub(crate) mod gradient;
pub(crate) mod tangent;
pub(crate) mod products;
pub(crate) mod period;
