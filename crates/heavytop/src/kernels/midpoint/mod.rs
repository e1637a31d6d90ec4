//! The closed midpoint rule, of one top in registers and of many in lanes.

pub(crate) mod formulas;
pub(crate) mod reduced_midpoint;
pub(crate) mod midpoint_sweep;
